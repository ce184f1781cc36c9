"""What is saved is what is opened, to the last bit, and the bytes depend on nothing else."""

import dataclasses
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from facemodel import facs
from facemodel.actions import ActionUnit, Emotion, JawMotion
from facemodel.errors import ProjectError
from facemodel.io.face_file import read_face, write_face
from facemodel.io.project_file import load_project, project_bytes, project_of, save_project
from facemodel.motions import EyeMotion, HeadMotion
from facemodel.project import Project, Settings
from tests.io.small_project import identical, small_face, small_project

numbers = st.floats(-1e5, 1e5)
weights = st.floats(-100, 100)
texts = st.text(max_size=40).filter(lambda text: text.isprintable() or "\n" in text)
names = st.text(st.characters(codec="utf-8"), min_size=1, max_size=30)
places = st.none() | st.tuples(st.floats(0, 1), st.floats(0, 1))


@st.composite
def action_units(draw: st.DrawFn) -> tuple[ActionUnit, ...]:
    numbers_of_units = draw(st.lists(st.integers(1, 999), max_size=6, unique=True))
    return tuple(
        ActionUnit(
            number=number,
            name=draw(names),
            group=draw(st.sampled_from(["upper", "jaw", "eyes"])),
            paired=draw(st.booleans()),
            muscles=draw(st.dictionaries(st.sampled_from(["zygomaticus_major", "orbicularis_oris"]), weights)),
            amplitude=draw(st.floats(0, 1e5)),
            jaw=draw(st.none() | st.builds(JawMotion, st.floats(-90, 90), numbers)),
            eyes=draw(st.none() | st.builds(EyeMotion, *(3 * [st.floats(-90, 90)]))),
            head=draw(st.none() | st.builds(HeadMotion, *(3 * [st.floats(-90, 90)]), numbers)),
            note=draw(texts),
            letters=tuple(draw(st.lists(st.floats(0.01, 2), min_size=5, max_size=5, unique=True).map(sorted))),
        )
        for number in numbers_of_units
    )


@st.composite
def projects(draw: st.DrawFn) -> Project:
    base = small_project()
    skin = base.face.skin
    positions = draw(hnp.arrays(np.float64, skin.positions.shape, elements=numbers))
    landmarks = draw(st.dictionaries(names, st.integers(0, len(positions) - 1), max_size=5))
    face = dataclasses.replace(base.face, skin=skin.moved(positions), landmarks=landmarks, provenance=draw(texts))
    units = draw(action_units())
    fields = [name for unit in units for name in unit.fields]
    some = st.dictionaries(st.sampled_from(fields), weights) if fields else st.just({})
    emotions = draw(st.lists(names, max_size=3, unique_by=str.lower))
    return Project(
        face=face,
        muscles=base.muscles,
        units=units,
        emotions=tuple(Emotion(name, draw(some), draw(places)) for name in emotions),
        expression=draw(some),
        settings=Settings(draw(st.sampled_from(["hct9", "hct12"])), draw(st.integers(1, 16))),
    )


@given(projects())
def test_a_project_comes_back_bit_by_bit(project: Project) -> None:
    data = project_bytes(project)
    again = project_of(data)
    assert identical(project, again)
    assert project_bytes(again) == data


def test_saving_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    save_project(small_project(), tmp_path / "first.risorius")
    save_project(small_project(), tmp_path / "second.risorius")
    assert (tmp_path / "first.risorius").read_bytes() == (tmp_path / "second.risorius").read_bytes()


def test_the_bytes_do_not_depend_on_the_hash_seed_or_the_clock(tmp_path: Path) -> None:
    script = (
        "import sys; from pathlib import Path; from facemodel.io.project_file import save_project;"
        "from tests.io.small_project import small_project;"
        "save_project(small_project(), Path(sys.argv[1]))"
    )
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "TZ": f"UTC+{seed}"}
        out = tmp_path / f"{seed}.risorius"
        subprocess.run([sys.executable, "-c", script, str(out)], check=True, env=environment, cwd=Path.cwd())
    assert (tmp_path / "1.risorius").read_bytes() == (tmp_path / "2.risorius").read_bytes()


def test_a_person_can_read_the_numbers(tmp_path: Path) -> None:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    text = zipfile.ZipFile(path).read("project.json").decode()
    assert '"origin": [32.0, 25.0, -2.0]' in text
    assert '"12L": 0.8' in text
    assert "lips “oo”" in text


def test_version_1_still_opens() -> None:
    """The stored file was written when version 1 was new; every later version has to open it."""
    stored = load_project(Path(__file__).parent / "schema-1.risorius")
    written = small_project()
    assert identical(dataclasses.replace(stored, units=written.units), written)
    kept, added = stored.units[: len(written.units)], stored.units[len(written.units) :]
    assert identical(kept, written.units)
    assert {unit.number for unit in added} == {*range(51, 59), *range(61, 67)}, "eyes and head can be turned now"
    assert identical(tuple(sorted(added, key=number)), tuple(sorted(_turning(), key=number)))


def number(unit: ActionUnit) -> int:
    return unit.number


def _turning() -> tuple[ActionUnit, ...]:
    return tuple(unit for unit in facs.action_units() if unit.eyes or unit.head)


@pytest.mark.parametrize("single", [False, True])
def test_a_face_comes_back(tmp_path: Path, single: bool) -> None:
    face = small_face()
    write_face(face, tmp_path / "sheet.face", single=single)
    again = read_face(tmp_path / "sheet.face")
    assert again.skin.positions.dtype == np.float64
    assert np.abs(again.skin.positions - face.skin.positions).max() <= (1e-5 if single else 0)
    assert identical(again.chart, face.chart)
    assert identical(again, face) or single


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"expression": {"12L": float("nan")}}, "expression.12L"),
        ({"expression": {"99": 1.0}}, "expression"),
        ({"settings": Settings("hct9", 0)}, "settings.density"),
        ({"muscles": ()}, "units[0].muscles"),
        ({"emotions": (Emotion("joy", {"13": 1.0}),)}, "emotions[0].weights"),
        ({"emotions": (Emotion("joy"), Emotion("Joy"))}, "emotions"),
    ],
)
def test_what_could_not_be_opened_again_is_not_saved(tmp_path: Path, change: dict[str, object], place: str) -> None:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    before = path.read_bytes()
    with pytest.raises(ProjectError) as caught:
        save_project(dataclasses.replace(small_project(), **change), path)
    assert f"cannot be saved: project.json, {place}" in str(caught.value)
    assert "take the last change back" in str(caught.value)
    assert path.read_bytes() == before
