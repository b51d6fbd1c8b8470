"""The cases of `mechanisms/*/truth.toml`, run as `crates/flexure/tests/mechanisms.rs` runs them. What
the manual plots is what the tests compare, and is compared here once more."""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass

import numpy as np

from .program import ROOT, Program

Values = dict[str, float]


@dataclass(frozen=True)
class Case:
    """One table of a mechanism: commands with places for inputs, and how its numbers are found."""

    folder: str
    models: tuple[str, ...]
    data: dict

    def rows(self) -> list[tuple[Values, Values]]:
        """Inputs and expected values."""
        find, columns = self.data["find"], self.data["columns"]
        named = [dict(zip(columns, row)) for row in self.data["rows"]]
        return [
            ({k: v for k, v in r.items() if k not in find}, {k: v for k, v in r.items() if k in find}) for r in named
        ]

    def values(self, program: Program, inputs: Values, guess: Values | None = None) -> Values:
        """The numbers of the case for some inputs."""
        commands = [_filled(c, inputs) for c in self.data["commands"]]
        find = self.data["find"]
        critical = next((f["critical"] for f in find.values() if "critical" in f), None)
        if critical is not None:
            (name,) = find
            return {name: self._critical(program, inputs, critical, (guess or {})[name])}
        if "modes" in self.data:
            modes = self._modes(program, commands)
            return {name: _of_modes(modes, f) * f.get("factor", 1.0) + f.get("offset", 0.0) for name, f in find.items()}
        last = program.run(self._paths(), commands, *self._options())
        return {name: _of_run(last, f) * f.get("factor", 1.0) + f.get("offset", 0.0) for name, f in find.items()}

    def compared(self, program: Program, inputs: Values, expected: Values) -> Values:
        """The numbers, which must be those of the table within its tolerance."""
        found = self.values(program, inputs, expected)
        tolerance = self.data["tolerance"]
        for name, wanted in expected.items():
            room = self.data["find"][name].get(
                "abs", tolerance.get("abs", 0.0) + tolerance.get("rel", 0.0) * abs(wanted)
            )
            if not math.isnan(wanted) and not abs(found[name] - wanted) <= room:
                raise AssertionError(
                    f"{self.folder}, {self.data['name']}, {inputs}: {name} is {found[name]:.9g}, not {wanted}"
                )
        return found

    def series(self, program: Program, inputs: Values, *options: str) -> Values:
        """All that a run records at its end."""
        commands = [_filled(c, inputs) for c in self.data["commands"]]
        return program.run(self._paths(), commands, *self._options(), *options)

    def shape(self, program: Program, inputs: Values, nodes: int) -> tuple[np.ndarray, np.ndarray]:
        """Where the nodes of a chain are, the root first."""
        last = self.series(program, inputs, "--all")
        return tuple(np.array([0.0] + [last[f"part_{k}_XFORM.{axis}"] for k in range(1, nodes + 1)]) for axis in "XY")

    def _paths(self) -> list:
        return [(ROOT / "mechanisms" / self.folder / m).resolve() for m in self.models]

    def _options(self) -> list[str]:
        angles = ["--beam-angles", "rotvec"] if self.data.get("rotation_vector") else []
        return angles + (["--nonlinear-shear"] if self.data.get("nonlinear_shear") else [])

    def _modes(self, program: Program, commands: list[str]) -> list[dict]:
        state = self.data["modes"]["state"]
        about = {"present": [], "equilibrium": ["--static"]}[state]
        return program.modes(self._paths(), commands, *about, *self._options())

    def _critical(self, program: Program, inputs: Values, load: str, guess: float) -> float:
        """The load at which the square of the lowest frequency passes zero, by the secant rule."""

        def square(value: float) -> float:
            commands = [_filled(c, {**inputs, load: value}) for c in self.data["commands"]]
            lowest = self._modes(program, commands)[0]
            return lowest["imaginary"] ** 2 - lowest["real"] ** 2

        a, b = 0.97 * guess, 0.995 * guess
        at_a, at_b = square(a), square(b)
        while abs(b - a) > 1e-5 * b:
            a, b, at_a = b, b - at_b * (b - a) / (at_b - at_a), at_b
            # The last point is not needed: the error of a secant is about the product of the two before.
            if abs(b - a) > 1e-5 * b:
                at_b = square(b)
        return b


def case(folder: str, name: str) -> Case:
    truth = tomllib.loads((ROOT / "mechanisms" / folder / "truth.toml").read_text())
    (data,) = [c for c in truth["case"] if c["name"] == name]
    return Case(folder, tuple(truth["models"]), data)


def _filled(text: str, inputs: Values) -> str:
    """Whole numbers are written without a point, so that they can count."""
    for name, value in inputs.items():
        text = text.replace(f"{{{name}}}", str(int(value)) if value == int(value) else repr(float(value)))
    return text


def _of_modes(modes: list[dict], find: dict) -> float:
    if "mode" in find:
        return modes[find["mode"] - 1]["frequency_hz"] * math.tau
    swinging = [m["damping_ratio"] for m in modes if m["damping_ratio"] < 1.0 - 1e-6]
    return swinging[find["damping"] - 1]


def _of_run(last: Values, find: dict) -> float:
    if "rotation" not in find:
        return last[find["series"]]
    angles = [math.radians(last[f"{find['series']}.R{k}"]) for k in (1, 2, 3)]
    return float(_rotation_vector(*angles)["xyz".index(find["rotation"])])


def _rotation_vector(first: float, second: float, third: float) -> np.ndarray:
    """Of a body 3-1-3 sequence, by quaternions; its length is at most pi."""
    plus, minus, half = (first + third) / 2.0, (first - third) / 2.0, second / 2.0
    w = math.cos(half) * math.cos(plus)
    v = np.array([math.sin(half) * math.cos(minus), math.sin(half) * math.sin(minus), math.cos(half) * math.sin(plus)])
    if w < 0.0:
        w, v = -w, -v
    size = float(np.linalg.norm(v))
    return v * (2.0 * math.atan2(size, w) / size) if size > 1e-12 else 2.0 * v
