"""Flexure: opens, checks, edits, simulates and plots MSC Adams models, without Adams.

>>> import flexure as fx
>>> model = fx.read("car.cmd")
>>> model.beams["torsion_bar"].ixx = 2.3e4
>>> run = model.simulate(end=5.0, steps=500)
>>> run["BAR.R1"]
"""

from flexure._errors import Diagnostic, FlexureError
from flexure._model import Candidate, Finding, Model, Modes, read
from flexure._native import BeamState, __version__
from flexure._objects import Object, Objects
from flexure._run import Run, Series

__all__ = [
    "BeamState",
    "Candidate",
    "Diagnostic",
    "Finding",
    "FlexureError",
    "Model",
    "Modes",
    "Object",
    "Objects",
    "Run",
    "Series",
    "__version__",
    "read",
]
