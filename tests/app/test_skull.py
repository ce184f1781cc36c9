"""The skull of a document: moved, snapped, replaced and checked, with undo to the last bit, in files and in scripts."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from app.authoring.jaw import with_jaw_axis
from app.authoring.skull import (
    at_template,
    has_template,
    proposed_region,
    snapped_to_depths,
    with_bone,
    with_jaw_region,
    with_pose,
)
from app.bone_reading import read_apart
from app.bone_watch import BoneWatch
from app.document import Document
from app.scripting import run_script
from app.skull_fitting import PLACES, SkullFitting
from app.skull_import import SkullImport
from facemodel.errors import ProjectError, SkullError
from facemodel.face import Pose
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.sameness import same
from facemodel.skull.depths import whole
from facemodel.skull.jaw_region import whole_skull
from facemodel.skull.mending import Bone
from facemodel.solve import Cancelled
from tests.app.conftest import small_project

ADA = new_project()
BONE = whole(ADA.face.skull)


def guest(scale: float = 0.1) -> Bone:
    """Return the face's own skull in another unit."""
    return Bone(Mesh(BONE.positions * scale + 7.0, BONE.triangles), len(BONE.triangles))


def written(path: Path, mesh: Mesh = BONE) -> Path:
    trimesh.Trimesh(mesh.positions, mesh.triangles, process=False).export(path)
    return path


STEPS = {
    "pose": lambda project: with_pose(project, Pose((3.0, -2.0, 1.0), (2.0, 0.0, -3.0), (1.05, 0.95, 1.0))),
    "pose alone": lambda project: with_pose(project, Pose((0.0, 4.0, 0.0)), origins=False),
    "snap": lambda project: snapped_to_depths(with_pose(project, Pose((2.0, 2.0, 2.0)))),
    "bone": lambda project: with_bone(project, Mesh(BONE.positions * [1.02, 0.99, 1.01], BONE.triangles)),
    "jaw": lambda project: with_jaw_region(project, whole_skull(project.face.skull).mesh.positions[:, 1] < -50),
    "axis": lambda project: with_jaw_axis(project, np.array([-44.0, -3, -20]), np.array([46.0, -4, -21])),
    "template": at_template,
}


@settings(max_examples=12)
@given(st.lists(st.sampled_from(sorted(STEPS)), min_size=1, max_size=5))
def test_whatever_is_done_to_a_skull_undo_ends_at_a_bit_identical_document(names: list[str]) -> None:
    document = Document(ADA)
    states = [document.project]
    for name in names:
        document.edit(STEPS[name](document.project), name)
        states.append(document.project)
    while document.history.to_undo is not None:
        document.undo()
    assert same(document.project, ADA)
    while document.history.to_redo is not None:
        document.redo()
    assert same(document.project, states[-1])


@pytest.mark.parametrize("name", STEPS)
def test_every_state_of_a_skull_is_saved_and_comes_back(name: str, tmp_path: Path) -> None:
    project = STEPS[name](ADA)
    document = Document(project)
    document.save(tmp_path / "skull.risorius")
    document.open(tmp_path / "skull.risorius")
    assert same(document.project.face.skull, project.face.skull)


def test_a_skull_without_any_jaw_is_saved_too(tmp_path: Path) -> None:
    skull = ADA.face.skull
    bald = replace(ADA, face=replace(ADA.face, skull=replace(skull, mandible=Mesh(np.zeros((0, 3)), NONE))))
    document = Document(bald)
    document.save(tmp_path / "skull.risorius")
    document.open(tmp_path / "skull.risorius")
    assert same(document.project.face.skull, bald.face.skull)


NONE = np.zeros((0, 3), dtype=np.int64)


def test_muscles_come_to_lie_on_another_skull_unless_they_are_told_to_stay() -> None:
    swollen = Mesh(BONE.positions + 1.5 * BONE.normals, BONE.triangles)
    after = with_bone(ADA, swollen)
    assert sum(not same(one, other) for one, other in zip(ADA.muscles, after.muscles, strict=True)) > 20
    assert with_bone(ADA, swollen, origins=False).muscles is ADA.muscles


def test_the_template_is_there_for_shipped_faces_and_only_where_the_skull_is_another() -> None:
    assert not has_template(ADA)
    moved = with_pose(ADA, Pose((1, 0, 0)))
    assert has_template(moved)
    assert same(at_template(moved).face.skull, ADA.face.skull)
    assert not has_template(small_project())
    with pytest.raises(SkullError, match="none of the shipped ones"):
        at_template(small_project())


def test_the_proposed_jaw_of_a_moved_skull_is_that_of_one_at_rest() -> None:
    moved = with_pose(ADA, Pose((0, 20, 0), (10, 0, 0)))
    assert np.array_equal(proposed_region(moved), proposed_region(ADA))
    assert np.array_equal(proposed_region(ADA), whole_skull(ADA.face.skull).jaw)


def test_an_axis_that_is_too_short_or_nowhere_is_refused() -> None:
    with pytest.raises(SkullError, match="at least 20 mm apart"):
        with_jaw_axis(ADA, np.zeros(3), np.array([3.0, 0, 0]))
    with pytest.raises(SkullError, match="is nowhere"):
        with_jaw_axis(ADA, np.zeros(3), np.array([np.nan, 0, 0]))


def begun() -> SkullFitting:
    fitting = SkullFitting()
    fitting.begin(guest(), "guest", ADA)
    return fitting


def test_a_skull_that_is_fitted_is_led_through_its_landmarks() -> None:
    fitting = begun()
    assert fitting.active == "nasion"
    told: list[bool] = []
    fitting.changed.connect(lambda: told.append(fitting.ready))
    for name in list(PLACES)[:5]:
        assert fitting.active == name
        vertex = BONE.tree.query(fitting.guest.targets[name])[1]
        fitting.pick(name, guest().mesh.positions[vertex])
        fitting.let_go(onward=True)
    assert fitting.ready
    assert told[-1]
    assert fitting.fit.rms < 3
    fitting.forget("nasion")
    assert fitting.active == "nasion"
    after = fitting.used(ADA)
    assert np.median(BONE.tree.query(whole(after.face.skull).positions)[0]) < 4
    fitting.end()
    assert not fitting.on


def test_a_skull_lies_still_while_a_pick_is_held() -> None:
    fitting = begun()
    fitting.propose()
    before = fitting.mesh
    fitting.held = True
    fitting.pick("nasion", fitting.picked["nasion"] + 1.0)
    assert fitting.mesh is before
    fitting.let_go()
    assert fitting.mesh is not before


def test_too_few_picks_and_a_head_without_landmarks_are_refused() -> None:
    fitting = begun()
    with pytest.raises(SkullError, match="0 landmarks are picked and at least 4 are needed"):
        fitting.used(ADA)
    with pytest.raises(SkullError, match="has 0 landmarks over bone"):
        SkullFitting().begin(guest(), "guest", small_project())


def test_quarter_turns_come_round_and_stop_where_something_is_fitted() -> None:
    fitting = begun()
    before = fitting.mesh.positions
    for axis in range(3):
        for _ in range(4):
            fitting.turn(axis)
    assert np.allclose(fitting.mesh.positions, before, atol=1e-6)
    fitting.turn(1)
    assert np.abs(fitting.mesh.positions - before).max() > 50
    fitting.propose()
    turned = fitting.mesh.positions
    fitting.turn(1)
    assert fitting.mesh.positions is turned


def test_a_file_is_read_in_another_process_and_can_be_stopped(tmp_path: Path) -> None:
    path = written(tmp_path / "skull.ply")
    steps: list[str] = []
    bone = read_apart(path, lambda text, _share: steps.append(text))
    assert len(bone.mesh.triangles) == len(BONE.triangles)
    assert steps[0] == "Reading the file"

    def stop(_text: str, _share: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        read_apart(path, stop)
    with pytest.raises(ProjectError, match="no such file"):
        read_apart(tmp_path / "none.ply")


def test_what_is_read_is_brought_to_the_fitting(tmp_path: Path) -> None:
    document, fitting = Document(ADA), SkullFitting()
    bringing = SkullImport(document, fitting)
    said: list[str] = []
    bringing.failed.connect(said.append)
    bringing.read(written(tmp_path / "skull.obj"))
    assert fitting.on
    assert fitting.guest.title == "skull.obj"
    assert not bringing.running
    bringing.read(tmp_path / "none.obj")
    assert "no such file" in said[0]


def test_the_watch_finds_out_anew_when_the_bone_moves_and_not_when_the_face_does() -> None:
    document = Document(ADA)
    watch = BoneWatch(document)
    told: list[str] = []
    watch.changed.connect(lambda: told.append(watch.found.complaint))
    watch.attend()
    assert told == [""]
    assert watch.current
    document.set_weights({"12": 0.5})
    assert len(told) == 1
    document.edit(with_pose(document.project, Pose((0, 0, 18))), "Move skull")
    assert told[1].startswith("Bone comes through the skin")
    assert watch.found.faults.left_out.any()
    document.undo()
    assert told[2] == ""
    watch.leave()
    document.redo()
    assert len(told) == 3
    assert not watch.current


def scripted(text: str, project: Project = ADA) -> tuple[Document, str]:
    document = Document(project)
    outcome = run_script(text, document)
    return document, outcome.error or outcome.output


def test_scripts_place_snap_and_reset_the_skull_as_one_step() -> None:
    document, said = scripted("skull.move(z=-3)\nskull.place(turn=(0, 4, 0), scale=1.05)\nprint(skull)")
    assert document.project.face.skull.placement.pose == Pose((0, 0, -3), (0, 4, 0), (1.05, 1.05, 1.05))
    assert said.startswith("skull: 10680 + 4280 triangles")
    assert document.history.done == ("Script",)
    document, said = scripted("skull.snap()\nprint(max(abs(each.off) for each in skull.depths()) < 5)")
    assert said == "True\n"
    document, said = scripted("skull.move(y=9)\nskull.reset()")
    assert document.project.face.skull.placement.pose == Pose()
    document, said = scripted("skull.move(z=20)\nprint(skull.check().complaint[:16])")
    assert said == "Bone comes throu\n"
    _, said = scripted("skull.place(shift=(1, 2))")
    assert "is three numbers" in said


def test_scripts_choose_the_jaw_and_its_axis() -> None:
    document, _ = scripted("skull.make_jaw(skull.proposed_jaw() & (skull.vertices()[:, 1] < -50))")
    assert 0 < len(document.project.face.skull.mandible.triangles) < 4280
    document, _ = scripted("skull.jaw_axis((-45, 0, -20), (45, 2, -20))")
    assert document.project.face.skull.jaw.axis.tolist() == [[-45, 0, -20], [45, 2, -20]]
    _, said = scripted("skull.make_jaw([True])")
    assert "by 7532 truth values" in said


def test_scripts_load_a_skull_and_fit_it(tmp_path: Path) -> None:
    path = written(tmp_path / "skull.stl", guest().mesh)
    document, said = scripted(f"print(round(skull.load({str(path)!r}), 1) < 2.5)")
    assert said == "True\n"
    assert document.history.done == ("Script",)
    assert np.median(BONE.tree.query(whole(document.project.face.skull).positions)[0]) < 4
    names = ("nasion", "pogonion", "zygion_L", "zygion_R", "gonion_L")
    targets = begun().guest.targets
    at = {name: (BONE.positions[BONE.tree.query(targets[name])[1]] * 0.1 + 7).tolist() for name in names}
    document, said = scripted(f"skull.load({str(path)!r}, {at!r}, kind='alike')")
    assert not said
    assert np.median(BONE.tree.query(whole(document.project.face.skull).positions)[0]) < 4
    _, said = scripted(f"skull.load({str(path)!r}, {{'nose': (0, 0, 0)}})")
    assert "“nose” is not picked on skulls" in said
    document, said = scripted(f"skull.load({str(tmp_path / 'none.obj')!r})")
    assert "no such file" in said
    assert document.history.done == ()
