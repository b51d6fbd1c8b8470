"""Objects of the model; their attributes are the parameters of their commands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from flexure import _native


class Object:
    """One object of the model.

    Reading an attribute gives its value in model units; setting one runs the class's modify
    command, which can be undone and is in the journal. Three coordinates are set in the frame in which they
    are read, that of the parent; one expression for all of them is taken as the command takes it.

    A text is a value: a comment, a word, the name of an object. Where an attribute takes numbers, it is a
    number with a unit or an expression, ``"210(newton/mm**2)"``, ``"(.m.length / 2)"``; in parentheses an
    expression also where it takes objects.
    """

    __slots__ = ("_native", "full_name")

    full_name: str
    """Full name, with a leading dot."""

    def __init__(self, native: _native.Session, full_name: str) -> None:
        object.__setattr__(self, "_native", native)
        object.__setattr__(self, "full_name", full_name)

    @property
    def name(self) -> str:
        """Name without path and quotes."""
        full = self.full_name
        return full[:-1].rpartition('."')[2] if full.endswith('"') else full.rpartition(".")[2]

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
        """Sets several attributes in one step. If one is refused, none is set."""
        self._native.modify(self.full_name, list(values.items()))

    def rename(self, name: str) -> None:
        """Gives the object another name; references follow."""
        object.__setattr__(self, "full_name", self._native.rename(self.full_name, name))

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
