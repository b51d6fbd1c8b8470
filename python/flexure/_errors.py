"""Diagnostics and the exception that carries them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Diagnostic:
    """One trouble: what, where, why and how to mend it."""

    severity: str
    """``error``, ``warning`` or ``note``."""
    code: str
    """``owner/what-is-wrong``."""
    message: str
    file: str | None = None
    line: int | None = None
    column: int | None = None
    notes: list[str] = field(default_factory=list)
    helps: list[str] = field(default_factory=list)
    text: str = ""
    """The diagnostic as the terminal shows it, with the underlined source."""

    @classmethod
    def _from_native(cls, native: Mapping[str, Any]) -> Diagnostic:
        return cls(**{name: native[name] for name in cls.__dataclass_fields__})

    def __str__(self) -> str:
        return self.text or f"{self.severity}[{self.code}]: {self.message}"


class FlexureError(Exception):
    """Something was refused. The model is as it was before the command."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics: list[Diagnostic] = list(diagnostics)
        errors = [d for d in self.diagnostics if d.severity == "error"] or self.diagnostics
        super().__init__("\n".join(str(d) for d in errors))

    @classmethod
    def _from_native(cls, native: Sequence[Mapping[str, Any]]) -> FlexureError:
        return cls([Diagnostic._from_native(d) for d in native])
