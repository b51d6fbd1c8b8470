"""The Python door: reading, editing by attribute, simulating, results with units, errors."""

from pathlib import Path

import numpy as np
import pytest

import flexure as fx

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def strip() -> fx.Model:
    return fx.read(EXAMPLES / "cantilever" / "cantilever.cmd")


def test_beams_have_the_command_s_parameters_as_attributes(strip):
    beam = strip.beams["beam_2"]
    assert beam.length == 250.0
    assert beam.unit("youngs_modulus") == "newton/mm**2"
    assert {"ixx", "iyy", "izz", "damping_ratio", "formulation"} <= set(dir(beam))
    assert beam.formulation == "linear"


def test_half_typed_commands_can_be_completed(strip):
    command = "force modify element_like beam beam_name = .strip.beam_3 "
    names = [candidate.text for candidate in strip.complete(command + "youngs")]
    assert names == [command + "youngs_modulus = "]
    units = strip.complete(command + "youngs")[0].note
    assert "newton/mm**2" in units
    # Behind a letter of two bytes the word still begins where Python counts it.
    assert [c.text for c in strip.complete("! Träger\nforce mod")] == ["! Träger\nforce modify "]
    assert strip.complete("no_such_command x = ") == []


def test_setting_an_attribute_is_a_command_that_can_be_undone(strip):
    beam = strip.beams["beam_2"]
    beam.youngs_modulus = 1.0e5
    assert strip.beams["beam_2"].youngs_modulus == 1.0e5
    beam.youngs_modulus = "7.1e10(newton/meter**2)"
    assert beam.youngs_modulus == pytest.approx(7.1e4, rel=1e-14)  # rounding of the unit factor
    assert strip.undo() and strip.undo()
    assert beam.youngs_modulus == 2.07e5


def test_equilibrium_bends_like_beam_theory(strip):
    strip.execute("force modify direct single_component_force single_component_force_name = tip_force function = \"-1.0\"")
    strip.beams["beam_1"].modify(area_of_cross_section=200.0, iyy=20 * 10**3 / 12, izz=10 * 20**3 / 12)
    run = strip.equilibrium()
    # truth: P L^3 / 3 E I + 1.2 P L / G A; the closed form is linear, deflection / length is 1e-3
    assert run["TIP.Z"][-1] == pytest.approx(-0.9662583574879227, rel=2e-5)
    assert run["TIP.Z"].unit == "mm"
    assert run["TIP", "Z"][-1] == run["TIP.Z"][-1]


def test_simulation_gives_arrays_with_units(strip):
    run = strip.simulate(end=0.01, steps=10)
    assert run.time == pytest.approx(np.linspace(0, 0.01, 11), abs=1e-15)
    assert run["ROOT.X"].unit == "newton"
    assert run.statistics["steps"] >= 10


def test_modes_of_the_strip(strip):
    modes = strip.modes()
    # four parts with six motions each: 48 eigenvalues, an oscillating mode stands for two
    assert np.where(modes.eigenvalue.imag > 0, 2, 1).sum() == 48
    assert np.all(np.diff(modes.frequency) >= -1e-9 * modes.frequency[:-1])
    assert modes.shapes.shape == (len(modes.frequency), 24) and len(modes.unknowns) == 24


def test_a_refused_command_raises_with_its_diagnostics_and_changes_nothing(strip):
    with pytest.raises(fx.FlexureError) as caught:
        strip.execute("force modify element_like beam beam_name = beam_1 yongs_modulus = 3")
    diagnostic = caught.value.diagnostics[0]
    assert diagnostic.code == "command/unknown-argument"
    assert any("youngs_modulus" in h for h in diagnostic.helps)
    assert strip.beams["beam_1"].youngs_modulus == 2.07e5


def test_unknown_names_are_key_and_attribute_errors(strip):
    with pytest.raises(KeyError):
        strip.beams["beam_99"]
    with pytest.raises(AttributeError):
        strip.beams["beam_1"].colour_of_the_day
    with pytest.raises(AttributeError):
        strip.beams["beam_1"].yongs_modulus = 3


def test_progress_can_stop_a_run(strip):
    class Enough(Exception):
        pass

    def stop(done, _sentence):
        if done > 0.2:
            raise Enough

    with pytest.raises(Enough):
        strip.simulate(end=0.1, steps=100, progress=stop)


def test_files_are_written(strip, tmp_path):
    strip.write(tmp_path / "strip.adm")
    assert "BEAM/" in (tmp_path / "strip.adm").read_text()
    again = fx.read(tmp_path / "strip.adm")
    # A dataset holds every digit, so the beam that is read is the beam that was written.
    assert again.beams["beam_2"].youngs_modulus == strip.beams["beam_2"].youngs_modulus
    assert again.beams["beam_2"].length == strip.beams["beam_2"].length
    strip.write(tmp_path / "strip.cmd")
    again = fx.read(tmp_path / "strip.cmd")
    assert list(again.beams) == list(strip.beams)
    strip.equilibrium().to_csv(tmp_path / "run.csv")
    assert (tmp_path / "run.csv").read_text().startswith("time,")


def test_a_swapped_beam_is_found_with_the_command_that_mends_it(strip):
    beam = strip.beams["beam_3"]
    i, j = beam.i_marker_name, beam.j_marker_name
    beam.modify(i_marker_name=j, j_marker_name=i)
    finding = next(f for f in strip.verify() if "beam_3" in f.diagnostic.message)
    strip.execute(finding.fix)
    assert not [f for f in strip.verify() if "beam_3" in f.diagnostic.message]


def test_a_model_is_kept_in_an_fx_file(strip, tmp_path):
    strip.beams["beam_2"].length = 123.0
    strip.write(tmp_path / "strip.fx")
    again = fx.read(tmp_path / "strip.fx")
    assert again.beams["beam_2"].length == 123.0
    # Twin: both written as commands.
    strip.write(tmp_path / "a.cmd")
    again.write(tmp_path / "b.cmd")
    assert (tmp_path / "a.cmd").read_bytes() == (tmp_path / "b.cmd").read_bytes()


def test_a_damaged_fx_file_is_refused(strip, tmp_path):
    path = tmp_path / "strip.fx"
    strip.write(path)
    path.write_bytes(path.read_bytes()[:5000])
    with pytest.raises(fx.FlexureError) as caught:
        fx.read(path)
    assert caught.value.diagnostics[0].code == "store/damaged"
