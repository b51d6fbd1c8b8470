"""Results of a run as numpy arrays with units."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from flexure import _native

if TYPE_CHECKING:
    import pandas


class Series(np.ndarray):
    """A series: an ndarray, shape ``(outputs,)``, with the label of its unit in ``.unit``."""

    unit: str

    def __new__(cls, values: npt.ArrayLike, unit: str) -> Series:
        series = np.asarray(values, dtype=float).view(cls)
        series.unit = unit
        return series

    def __array_finalize__(self, source: Any) -> None:
        self.unit = getattr(source, "unit", "")


class Run(Mapping[str, Series]):
    """A finished run: a mapping from series names to arrays, ``time`` first.

    Values are in model units. ``run["beam", "FX"]`` is short for ``run["beam.FX"]``.
    """

    def __init__(self, native: _native.Run) -> None:
        self._native = native
        self._names = native.names()

    def __getitem__(self, name: str | tuple[str, str]) -> Series:
        key = ".".join(name) if isinstance(name, tuple) else name
        values, unit = self._native.series(key)
        return Series(values, unit)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and name.lower() in {n.lower() for n in self._names}

    def __repr__(self) -> str:
        return f"<Run: {self.title}, {len(self.time)} outputs of {len(self) - 1} series>"

    @property
    def time(self) -> Series:
        """Output times, s."""
        return self["time"]

    @property
    def title(self) -> str:
        return self._native.title()

    @property
    def messages(self) -> list[str]:
        """What the solver had to say: redundant constraints, warnings of elements."""
        return self._native.messages()

    @property
    def interrupted(self) -> bool:
        """True if the run was stopped before its end; what was computed is here."""
        return self._native.interrupted()

    @property
    def statistics(self) -> dict[str, int]:
        """Steps, Newton iterations, factorisations, ..."""
        return self._native.statistics()

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        self._native.write(os.fspath(path))

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes Parquet whatever the extension; units are in the file's metadata."""
        target = os.fspath(path)
        if target.lower().endswith(".parquet"):
            self._native.write(target)
        else:
            self._native.write(target + ".parquet")
            os.replace(target + ".parquet", target)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame indexed by time; units are in ``frame.attrs["units"]``."""
        import pandas

        frame = pandas.DataFrame({name: np.asarray(self[name]) for name in self._names[1:]}, index=np.asarray(self.time))
        frame.index.name = "time"
        frame.attrs["units"] = {name: self[name].unit for name in self._names}
        return frame

    def plot(self, *names: str, ax: Any = None) -> Any:
        """Draws series over time with matplotlib and returns the axes."""
        import matplotlib.pyplot as plt

        axes = ax if ax is not None else plt.figure().subplots()
        chosen = names or tuple(self._names[1:7])
        for name in chosen:
            axes.plot(self.time, self[name], label=name)
        axes.set_xlabel("time (s)")
        units = {self[name].unit for name in chosen}
        axes.set_ylabel(units.pop() if len(units) == 1 else "")
        axes.grid(visible=True, alpha=0.3)
        axes.legend()
        return axes
