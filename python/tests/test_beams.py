"""Beams through the Python door: what goes through them, and how they are taken."""

import math
from pathlib import Path

import pytest

import flexure as fx

CHAINS = Path(__file__).parents[2] / "mechanisms" / "beams" / "beams.cmd"


def chain(commands: str) -> fx.Model:
    model = fx.read(CHAINS)
    for line in commands.splitlines():
        model.execute(line)
    return model


def test_a_cantilever_carries_its_tip_force_to_the_clamp():
    model = chain("chain n=2 formulation=linear\ntip force y=1e-3")
    loads = model.beam_loads(static=True)
    assert list(loads) == [".chain.beam_1", ".chain.beam_2"]
    first, last = loads.values()
    # truth: V = P, M = P (L - x), energy P^2 L^3/6EI; rotations of 5e-4 count with their squares
    assert first.force == pytest.approx((0, 1e-3, 0), abs=1e-9)
    assert first.moment(0) == pytest.approx((0, 0, 1e-3), abs=1e-9)
    assert first.moment(0.5) == pytest.approx((0, 0, 0.75e-3), abs=1e-9)
    assert last.moment(1) == pytest.approx((0, 0, 0), abs=1e-9)
    assert first.energy + last.energy == pytest.approx(1e-6 / 6, rel=1e-6)
    assert (first.length, first.power) == (0.5, 0)
    assert first.residual < 1e-12
    assert first.units["moment"] == "newton-meter" and first.units["power"] == "newton-meter/second"
    assert "beam_1" in repr(first)


def test_runs_record_what_goes_through_beams():
    model = chain("chain n=2 formulation=nonlinear ratio=0.01\ntip force y=1")
    run = model.simulate(end=0.2, steps=4, beam_loads=True)
    assert run["beam_1.MZ_J"].unit == "newton-meter"
    assert run["beam_1", "POWER"][-1] > 0 and run["beam_1.RESIDUAL"].max() < 1e-12
    assert "part_1_XFORM.X" not in run and "beam_1.FX" not in run
    # twin: the same state, from where the run left the model
    last = model.beam_loads()[".chain.beam_1"]
    assert run["beam_1.MZ_J"][-1] == pytest.approx(last.moment(0)[2], rel=1e-9)
    # twin: everything recorded holds it too
    assert chain("chain n=2\ntip force y=1").equilibrium(all=True)["beam_2.N"].unit == "newton"
    assert "beam_1.N" not in model.equilibrium()
    assert "beam_1.N" in model.equilibrium(beam_loads=True)


def test_after_a_time_from_the_equilibrium_the_loads_are_those_of_the_equilibrium():
    model = chain("chain n=1 formulation=nonlinear\ntip force y=1")
    still = model.beam_loads(static=True)[".chain.beam_1"].moment(0)
    assert model.beam_loads(static=True, at=0.1)[".chain.beam_1"].moment(0) == pytest.approx(still, abs=1e-5)
    moving = model.beam_loads(at=0.1)[".chain.beam_1"].moment(0)
    assert moving[2] != pytest.approx(still[2], abs=1e-2)


def test_a_model_without_beams_says_so():
    model = chain("chain n=1")
    model.execute("force delete force_name = .chain.beam_1")
    with pytest.raises(fx.FlexureError) as caught:
        model.beam_loads()
    assert caught.value.diagnostics[0].code == "beams/none"


def test_nonlinear_beams_shear_where_it_is_asked_for():
    model = chain("chain n=1 formulation=nonlinear ea=100 shear_y=1.2\ntip force y=1e-6")
    assert model.nonlinear_shear is False
    # truth: P L^3/3EI, and with shear P L ASY/GA more
    assert model.equilibrium()["TIP.Y"][-1] == pytest.approx(1e-6 / 3, rel=1e-7)
    model.nonlinear_shear = True
    assert model.nonlinear_shear is True
    assert model.equilibrium()["TIP.Y"][-1] == pytest.approx(1e-6 / 3 + 1.2e-8, rel=1e-7)


def test_angles_of_linear_beams_are_measured_as_asked_for():
    model = chain("chain n=1 formulation=linear")
    assert model.beam_angles == "projected"
    # The tip turned by two equal angles about y and z of the clamp, as a rotation vector without x component.
    b = c = 0.1
    turn = math.hypot(b, c)
    two = (1 - math.cos(turn)) / turn**2
    r13, r23 = math.sin(turn) / turn * b, two * b * c
    r33, r31 = math.cos(turn) + two * c * c, -math.sin(turn) / turn * b
    r32 = r23
    angles = [math.atan2(r13, -r23), math.acos(r33), math.atan2(r31, r32)]
    turned = ", ".join(repr(math.degrees(a)) for a in angles)
    model.execute(f"marker modify marker_name = .chain.part_1.node_1 orientation = {turned}")
    torque = lambda: model.beam_loads()[".chain.beam_1"].moment(1)[0]  # noqa: E731
    # truth: projected, the twist is atan2(-R23, R33); GJ/L = 1 N m
    assert torque() == pytest.approx(math.atan2(-r23, r33), abs=1e-12)
    model.beam_angles = "rotvec"
    assert model.beam_angles == "rotvec"
    assert torque() == pytest.approx(0, abs=1e-12)
    with pytest.raises(ValueError, match="projected"):
        model.beam_angles = "euler"
