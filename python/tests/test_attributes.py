"""Attributes: what can be read can be set, and a text is a value, never a piece of a command."""

import random

import numpy as np
import pytest

import flexure as fx

SCENE = """
model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 100,0,0 orientation = 90,0,0
marker create marker_name = .m.p.i location = 110,5,0
marker create marker_name = .m.p.j location = 120,5,0
material create material_name = .m.metal density = 1 youngs_modulus = 1 poissons_ratio = 0.3
variable create variable_name = .m.v real_value = 2
force create element_like beam beam_name = .m.b i_marker_name = .m.p.i j_marker_name = .m.p.j length = 3
"""


@pytest.fixture
def model() -> fx.Model:
    model = fx.Model()
    model.execute(SCENE)
    return model


def test_variables_markers_and_materials_take_values(model):
    model.variables["v"].real_value = 3
    assert model.variables["v"].real_value == 3
    model.variables["v"].modify(real_value=np.float64(4), comments=["why"])
    assert model.variables["v"].real_value == 4
    for place in ([1, 2, 3], (1.0, 2.0, 3.0), np.array([1, 2, 3])):
        model.markers["i"].location = [0, 0, 0]
        model.markers["i"].location = place
        assert model.markers["i"].location == pytest.approx([1, 2, 3], abs=0)
    metal = model.objects("material")["metal"]
    metal.density = 7.8e-6
    assert metal.density == 7.8e-6


def test_numbers_with_units_expressions_and_objects_are_taken(model):
    beam = model.beams["b"]
    # truth: 1 m is 1000 mm
    for given, length in [("2(meter)", 2000), ("(.m.v * 2)", 4), ("3.5", 3.5), (np.int64(7), 7), ("1e1", 10)]:
        beam.length = given
        assert beam.length == pytest.approx(length, rel=1e-14)
    beam.i_marker_name, beam.j_marker_name = model.markers["j"], "i"
    assert (beam.i_marker_name, beam.j_marker_name) == (".m.p.j", ".m.p.i")
    beam.formulation = "nonlinear"
    assert beam.formulation == "nonlinear"
    model.markers["i"].location = [1, "(.m.v)", 3]
    assert model.markers["i"].location[1] == 2


ODD = ["a b", 'say "hi"', "! x", "a, b", "(1+1)", "c:\\d\\", "&", "", " ", "x = 1", "'", "\t", "é λ"]


def test_a_text_is_a_value(model):
    beam = model.beams["b"]
    for odd in ODD:
        beam.comments = [odd]
        assert beam.comments == [odd]
        beam.comments = odd
        assert beam.comments == [odd]
    beam.comments = ODD
    assert beam.comments == ODD
    beam.comments = beam.comments
    assert beam.comments == ODD


def test_random_texts_are_kept_or_refused(model):
    beam = model.beams["b"]
    seeded = random.Random(7)
    for _ in range(300):
        texts = ["".join(seeded.choices("ab \"'\\&!,()=$.\n\r\t", k=seeded.randrange(8))) for _ in range(2)]
        before = beam.comments
        try:
            beam.comments = texts
        except fx.FlexureError as error:
            assert any("\n" in text or "\r" in text for text in texts)
            assert error.diagnostics[0].code == "attribute/not-writable"
            assert beam.comments == before
        else:
            assert beam.comments == texts


@pytest.mark.parametrize("attribute", ["comments", "i_marker_name", "length", "formulation"])
def test_a_text_with_a_line_break_executes_nothing(model, attribute):
    beam = model.beams["b"]
    for odd in ["1\nmodel create model_name = evil", '"\nmodel create model_name = evil\n"']:
        try:
            setattr(beam, attribute, odd)
        except fx.FlexureError:
            pass
        assert model.name == "m" and model.beams["b"].length == 3
    with pytest.raises(fx.FlexureError):
        beam.rename("c\nmodel create model_name = evil")
    assert model.name == "m"


def test_what_is_no_value_is_refused(model):
    beam = model.beams["b"]
    for odd in ({"a": 1}, b"bytes", object()):
        with pytest.raises(TypeError):
            beam.length = odd
    for odd in (float("nan"), float("inf"), [], None, "two words", "1) + (2", "3 ! x"):
        with pytest.raises(fx.FlexureError):
            beam.length = odd
    assert beam.length == 3


def test_a_refused_value_takes_the_others_back(model):
    part = model.parts["p"]
    with pytest.raises(fx.FlexureError):
        part.modify(mass=3, visibility="nonsense")
    assert part.mass is None


def test_an_object_is_renamed(model):
    marker = model.markers["i"]
    marker.rename("odd one")
    assert (marker.full_name, marker.name) == ('.m.p."odd one"', "odd one")
    assert model.beams["b"].i_marker_name == '.m.p."odd one"'
