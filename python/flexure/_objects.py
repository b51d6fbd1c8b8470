"""Objects of the model; their attributes are the parameters of their commands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from flexure import _native


def command_text(value: Any) -> str:
    """A Python value as command text: numbers to the last digit, lists with commas.

    Strings are command text already: ``"210(newton/mm**2)"``, ``"(.m.length / 2)"``, ``"linear"``.
    """
    if isinstance(value, Object):
        return value.full_name
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, str):
        text = value.strip()
        bare_unit = text[:1].isdigit() and not text.replace(".", "").isdigit()
        return f"({text})" if bare_unit and not _is_number(text) else text
    if isinstance(value, (Sequence, np.ndarray)):
        return ", ".join(command_text(v) for v in value)
    raise TypeError(f"{type(value).__name__} cannot be written as command text")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


class Object:
    """One object of the model.

    Reading an attribute gives its value in model units; setting one runs the class's modify
    command, which can be undone and is in the journal.
    """

    __slots__ = ("_native", "full_name")

    full_name: str
    """Full name, with a leading dot."""

    def __init__(self, native: _native.Session, full_name: str) -> None:
        object.__setattr__(self, "_native", native)
        object.__setattr__(self, "full_name", full_name)

    @property
    def name(self) -> str:
        return self.full_name.rpartition(".")[2]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        value, _unit, _expression = self._native.attribute(self.full_name, name)
        return value

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "name":
            self.rename(value)
            return
        if name not in self._native.attributes(self.full_name):
            raise AttributeError(f"{self.full_name} has no attribute {name}; it has {', '.join(dir(self))}")
        self.modify(**{name: value})

    def modify(self, **values: Any) -> None:
        """Sets several attributes in one command."""
        self._native.modify(self.full_name, [(name, command_text(value)) for name, value in values.items()])

    def rename(self, name: str) -> None:
        """Gives the object another name; references follow."""
        parent = self.full_name.rpartition(".")[0]
        self._native.execute(f"entity modify entity_name = {self.full_name} new_entity_name = {parent}.{name}")
        object.__setattr__(self, "full_name", f"{parent}.{name}")

    def unit(self, attribute: str) -> str:
        """Label of the unit an attribute is in."""
        return self._native.attribute(self.full_name, attribute)[1]

    def expression(self, attribute: str) -> str | None:
        """Text of the expression an attribute is computed by, or none."""
        return self._native.attribute(self.full_name, attribute)[2]

    def __dir__(self) -> list[str]:
        return self._native.attributes(self.full_name)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Object) and other.full_name.lower() == self.full_name.lower()

    def __hash__(self) -> int:
        return hash(self.full_name.lower())

    def __repr__(self) -> str:
        return f"<{self.full_name}>"


class Objects(Mapping[str, Object]):
    """All objects of a class or family, by short or full name."""

    def __init__(self, native: _native.Session, wanted: str) -> None:
        self._native = native
        self._wanted = wanted

    def __getitem__(self, name: str) -> Object:
        return Object(self._native, self._native.resolve(name, self._wanted))

    def __iter__(self) -> Iterator[str]:
        return iter(self._native.objects(self._wanted))

    def __len__(self) -> int:
        return len(self._native.objects(self._wanted))

    def __repr__(self) -> str:
        return f"<{len(self)} of class {self._wanted}>"
