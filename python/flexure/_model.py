"""The model: reading, editing, simulating, verifying, writing."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from flexure import _native
from flexure._errors import Diagnostic
from flexure._native import BeamState
from flexure._objects import Objects
from flexure._run import Run


@dataclass(frozen=True)
class Finding:
    """Something verification found, and the command that mends it if that is certain."""

    diagnostic: Diagnostic
    fix: str | None


class Candidate(NamedTuple):
    """One way to go on with half-typed commands."""

    text: str
    """The commands with it."""
    note: str
    """Type, unit, default and a line of explanation."""


@dataclass(frozen=True)
class Modes:
    """Linear modes, lowest frequency first. Arrays have one entry for each mode."""

    frequency: npt.NDArray[np.float64]
    """Undamped natural frequencies, Hz."""
    damping_ratio: npt.NDArray[np.float64]
    eigenvalue: npt.NDArray[np.complex128]
    """1/s."""
    shapes: npt.NDArray[np.complex128]
    """Modes x unknowns: translations of the centre of mass (m, global), rotations (rad, body)."""
    unknowns: list[str]
    """Names of the unknowns."""


class Model:
    """A session with a model in it."""

    def __init__(self) -> None:
        self._native = _native.Session()
        self.warnings: list[Diagnostic] = []
        """What was worth a warning so far."""

    @property
    def name(self) -> str | None:
        return self._native.model()

    @property
    def beams(self) -> Objects:
        return self.objects("beam")

    @property
    def parts(self) -> Objects:
        return self.objects("part")

    @property
    def markers(self) -> Objects:
        return self.objects("marker")

    @property
    def joints(self) -> Objects:
        return self.objects("joint")

    @property
    def forces(self) -> Objects:
        return self.objects("force")

    @property
    def variables(self) -> Objects:
        return self.objects("variable")

    def objects(self, wanted: str) -> Objects:
        """Objects of a class (``beam``) or family (``force``, ``constraint``, ``geometry``)."""
        return Objects(self._native, wanted)

    @property
    def beam_angles(self) -> str:
        """How LINEAR and STRING beams measure the rotation of I from J.

        ``"projected"``: each angle about its own axis of J, like the functions AX, AY and AZ. ``"rotvec"``: the
        components of the rotation vector. Counts for every analysis from now on.
        """
        return self._native.beam_angles()

    @beam_angles.setter
    def beam_angles(self, how: str) -> None:
        self._native.set_beam_angles(how)

    @property
    def nonlinear_shear(self) -> bool:
        """Whether NONLINEAR beams shear by their shear ratios. Counts for every analysis from now on."""
        return self._native.nonlinear_shear()

    @nonlinear_shear.setter
    def nonlinear_shear(self, shear: bool) -> None:
        self._native.set_nonlinear_shear(shear)

    def execute(self, command: str) -> list[Run]:
        """Executes command text. Returns the runs it made, usually none.

        Raises
        ------
        FlexureError
            If a command is refused. What it had begun is taken back.
        """
        self._keep(self._native.execute(command))
        return [Run(run) for run in self._native.take_runs()]

    def simulate(
        self,
        *,
        end: float,
        steps: int | None = None,
        dtout: float | None = None,
        kinematic: bool = False,
        static: bool = False,
        integrator: str | None = None,
        error: float | None = None,
        hmax: float | None = None,
        all: bool = False,  # noqa: A002  (the command line's word)
        beam_loads: bool = False,
        progress: Callable[[float, str], object] | None = None,
    ) -> Run:
        """Simulate the motion from the initial state to `end`.

        Parameters
        ----------
        end : float
            Final time, s.
        steps, dtout : int, float
            Number of equal output steps (default 100), or the time between outputs, s.
        kinematic : bool
            Kinematic analysis of a model without degrees of freedom.
        static : bool
            Start from the static equilibrium.
        integrator : str
            Adams name: ``gstiff``, ``si2``, ``hht``, ...
        error : float
            Local error tolerance.
        hmax : float
            Largest step, s.
        all : bool
            Record parts, joints, motions and forces too.
        beam_loads : bool
            Record what goes through every beam, its energy and the power it takes: ``run["beam.MZ_J"]``.
        progress : callable
            Called with the done part and a sentence; raising stops the run.
        """
        if static:
            self._simulate("static", integrator=integrator, all=all, beam_loads=beam_loads)
        kind = "kinematic" if kinematic else "dynamic"
        return self._simulate(
            kind,
            end=end,
            steps=steps,
            dtout=dtout,
            integrator=integrator,
            error=error,
            hmax=hmax,
            all=all,
            beam_loads=beam_loads,
            progress=progress,
        )

    def equilibrium(self, *, all: bool = False, beam_loads: bool = False) -> Run:  # noqa: A002
        """Static equilibrium; the run has one output."""
        return self._simulate("static", all=all, beam_loads=beam_loads)

    def beam_loads(self, *, static: bool = False, at: float | None = None) -> dict[str, BeamState]:
        """What goes through every beam: the state of each by its full name, in order of creation.

        Without arguments as modelled, or where the last analysis left the model; with `static` in the static
        equilibrium; with `at` after a dynamic simulation to that time (s), with both from the equilibrium on.

        A state has ``.force`` (N, Vy, Vz), ``.moment(station)`` (T, My, Mz at a share of the way from J to I),
        ``.angle``, ``.energy``, ``.power``, ``.residual``, ``.length`` and ``.units``. Forces and moments act on
        the face that looks to I: tension is positive, dMy/dx = Vz, dMz/dx = -Vy.
        """
        return {state.name: state for state in self._native.beams(static, at)}

    def _simulate(self, kind: str, **options: object) -> Run:
        run = Run(self._native.simulate(kind, **options))  # type: ignore[arg-type]
        self._native.take_runs()
        return run

    def modes(self, *, static: bool = False, spin: float | None = None, about: str | None = None) -> Modes:
        """Linear modes about the initial state or, with `static`, about the equilibrium.

        With `spin` (rad/s) and `about` (a marker), about the steady spin of the whole model round the
        marker's z axis, deflected by the centrifugal forces.
        """
        if (spin is None) != (about is None):
            raise ValueError("`spin` (rad/s) and `about` (the marker whose z axis it is about) go together")
        found = self._native.modes(static, None if spin is None else (about, spin))
        return Modes(
            frequency=found["frequency"],
            damping_ratio=found["damping_ratio"],
            eigenvalue=found["real"] + 1j * found["imaginary"],
            shapes=found["shape_real"] + 1j * found["shape_imaginary"],
            unknowns=found["unknowns"],
        )

    def verify(self) -> list[Finding]:
        """The traps of beams and whatever else would spoil a simulation."""
        _report, findings = self._native.verify()
        return [Finding(Diagnostic._from_native(f), f["fix"]) for f in findings]

    def verify_report(self) -> list[str]:
        """Degrees of freedom and redundant constraints, in the words of the product's report."""
        return self._native.verify()[0]

    def complete(self, text: str) -> list[Candidate]:
        """What may stand at the end of half-typed commands, as Tab shows it in the command window."""
        start, found = self._native.complete(text)
        return [Candidate(text[:start] + candidate, note) for candidate, note in found]

    def undo(self) -> bool:
        """Takes the last command back; false if there is none."""
        return self._native.undo()

    def redo(self) -> bool:
        return self._native.redo()

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes `.cmd`, `.adm` or `.fx`; what the file does not hold is added to `warnings`."""
        self._keep(self._native.write(os.fspath(path)))

    def _keep(self, native: list[dict[str, object]]) -> None:
        self.warnings.extend(Diagnostic._from_native(d) for d in native)

    def __repr__(self) -> str:
        return f"<Model {self.name}>"


def read(path: str | os.PathLike[str]) -> Model:
    """Reads a command file. Simulations it asks for are left out.

    Raises
    ------
    FlexureError
        If the file has errors; `.diagnostics` has them all.
    """
    model = Model()
    model._keep(model._native.read(os.fspath(path)))
    return model
