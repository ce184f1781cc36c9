"""An expression goes to another project as text, and what that has no unit for is told and not guessed."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring.units import renamed, with_new_unit
from app.errors import NumberError, UnitError
from app.expression_clipboard import expressions_of, expressions_text, told, with_pasted
from facemodel.actions import Emotion, expand
from facemodel.io.project_file import project_bytes, project_of
from facemodel.project import Project
from tests.app.conftest import UNITS, small_project

FIELDS = [field for unit in UNITS for field in unit.fields]


@given(
    st.dictionaries(st.sampled_from(FIELDS), st.sampled_from([0.1, 0.25, 0.333333, 1.0, 1.75]), min_size=1),
    st.sampled_from(["smile", "half a smile", "Wut & Trauer", "12 o'clock"]),
)
def test_copied_and_pasted_it_is_the_same(weights: dict[str, float], name: str) -> None:
    project = small_project()
    text = expressions_text([Emotion(name, weights)], project.units)
    made, (called,) = with_pasted(project, expressions_of(text, project.units))
    assert called == name
    assert expand(made.emotions[-1].weights, made.units) == pytest.approx(weights)
    project_of(project_bytes(made))


def test_a_unit_of_ones_own_goes_by_its_name_because_numbers_mean_something_else_elsewhere(project: Project) -> None:
    here, own = with_new_unit(project, "half wink")
    text = expressions_text([Emotion("sly", {f"{own}L": 0.5, "17": 0.25})], here.units)
    assert text == "sly: half wink L=0.5 17=0.25" or text == "sly: 17=0.25 half wink L=0.5"
    there, _ = with_new_unit(with_new_unit(project, "sneer")[0], "half wink")
    (read,) = expressions_of(text, there.units)
    assert read.weights == {"102L": 0.5, "17": 0.25}


def test_what_the_project_has_no_unit_for_is_left_out_and_told(project: Project) -> None:
    read = expressions_of("surprise: 1=1 26=0.5 puffed cheek L=0.3", project.units)
    made, names = with_pasted(project, read)
    assert names == ("surprise 2",)
    assert dict(made.emotions[-1].weights) == {"26": 0.5}
    assert told(read, names) == (
        "Pasted “surprise 2”. Left out “1”, “puffed cheek L”: this project has no such action unit."
    )
    with pytest.raises(UnitError, match="“1”, “2” alone"):
        expressions_of("brows: 1=1 2=0.5", project.units)


def test_several_lines_are_several_expressions_and_a_bare_text_is_one_without_a_name(project: Project) -> None:
    read = expressions_of("a: 12=0.5\n\nb: 17=0.5 26:0.25\n", project.units)
    assert [each.name for each in read] == ["a", "b"]
    assert read[1].weights == {"17": 0.5, "26": 0.25}
    for bare in ("12L=0.5 17=50%", "12L: 0.5 17: 1/2", "au 12L=0.5; chin raiser=0.5"):
        (one,) = expressions_of(bare, project.units)
        assert (one.name, one.weights) == ("pasted expression", {"12L": 0.5, "17": 0.5})
    (scored,) = expressions_of("L12E+17E", project.units)
    assert scored.weights == {"12L": 1.0, "17": 1.0}


@pytest.mark.parametrize("text", ["", " \n ", "x" * 200_000, "smile: 12=0"])
def test_what_holds_no_expression_is_refused(project: Project, text: str) -> None:
    with pytest.raises(UnitError):
        expressions_of(text, project.units)


@pytest.mark.parametrize("text", ["Dear Sir or Madam", "smile: 12=abc", "smile: 12=", "smile: twelve"])
def test_what_is_no_expression_is_refused_with_a_sentence(project: Project, text: str) -> None:
    with pytest.raises((UnitError, NumberError), match=r"\.$"):
        expressions_of(text, project.units)


def test_a_name_that_would_break_the_text_goes_by_number(project: Project) -> None:
    odd = renamed(replace(with_new_unit(project)[0]), 101, "left: a=b")
    text = expressions_text([Emotion("odd", {"101L": 0.5})], odd.units)
    assert text == "odd: 101L=0.5"
