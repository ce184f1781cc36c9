"""A gesture is shown while it lasts, becomes one step when it ends, and leaves no trace when it is cancelled."""

from dataclasses import replace

import numpy as np
import pytest

from app.commands import PaintLayers
from app.document import Document
from app.tools import TOOLS, Bench, FibreTool, Hit, Pointer, Ray, ToolBox, Working, skin_hit, skull_hit
from app.tools.laying import group_at
from app.view import View
from facemodel.errors import UnknownNameError
from facemodel.face import Face
from facemodel.laying.handles import handles
from facemodel.painting.layers import LAYER
from facemodel.project import Project
from facemodel.projects import new_project
from fem import Support
from fem.types import BoolArray, FloatArray

BEFORE_THE_FACE = np.array([0.0, 0, 200])
UP = np.array([0.0, 6, 0])


def facing(place: FloatArray) -> Ray:
    """Return the line of sight to a place from straight before it."""
    return Ray(place + BEFORE_THE_FACE, np.array([0.0, 0, -1]))


class FrontView:
    """A viewport that looks straight at the patch: one millimetre is one pixel."""

    def __init__(self, face: Face) -> None:
        self.face = face

    def skin_on_screen(self) -> tuple[FloatArray, BoolArray]:
        places = self.face.skin.positions[:, :2] * [1, -1] + 100
        return places, np.ones(len(places), dtype=np.bool_)


def bench_for(document: Document, workspace: str) -> Bench:
    view = View()
    view.change(workspace=workspace)
    return Bench(document, view, projector=FrontView(document.project.face))


@pytest.fixture
def box(document: Document) -> ToolBox:
    box = ToolBox(bench_for(document, "tissue"), TOOLS)
    box.bench.brush.change(layer="stiffness", radius=15.0, strength=1.0, hardness=1.0, mirror=False)
    box.bench.brush.set_mode("set")
    box.bench.brush.set_value(0.01)
    box.take("brush")
    return box


@pytest.fixture
def seen(box: ToolBox) -> list[Working]:
    found: list[Working] = []
    box.bench.sight.working_changed.connect(found.append)
    return found


def on_skin(face: Face, x: float, y: float, **how: object) -> Pointer:
    """Return the pointer on the patch of skin over a place in the plane."""
    away = np.abs(face.skin.positions[face.skin.triangles].mean(axis=1)[:, :2] - [x, y]).sum(axis=1)
    triangle = int(np.argmin(away))
    hit = skin_hit(face, triangle, np.array([0.4, 0.3, 0.3]))
    return Pointer(100 + x, 100 - y, skin=hit, ray=facing(hit.position), **how)  # type: ignore[arg-type]


def stroke(box: ToolBox, *places: tuple[float, float], modifiers: frozenset[str] = frozenset()) -> None:
    face = box.bench.document.project.face
    first, *rest = places
    box.press(on_skin(face, *first, modifiers=modifiers))
    for place in rest:
        box.move(on_skin(face, *place, modifiers=modifiers))
    box.release(on_skin(face, *places[-1], modifiers=modifiers))


def drawn(face: Face, layer: str, seen: list[Working]) -> FloatArray:
    """Return the values that a viewport shows that has drawn all it was told."""
    values = LAYER[layer].values(face)
    for each in seen:
        values[each.vertices] = each.values
    return values


def test_a_stroke_is_drawn_while_it_lasts_and_is_one_step_when_it_ends(
    box: ToolBox, seen: list[Working], document: Document, project: Project
) -> None:
    heard: list[tuple[str, tuple[int, ...]]] = []
    document.layers_changed.connect(lambda name, vertices: heard.append((name, tuple(vertices))))
    face = project.face
    box.press(on_skin(face, -20, 0))
    assert box.busy
    box.move(on_skin(face, 20, 0))
    assert document.project is project
    while_held = drawn(face, "stiffness", seen)
    assert (while_held == 0.01).sum() > 10
    box.release(on_skin(face, 20, 0))
    assert not box.busy
    assert document.history.done == ("Paint tissue stiffness",)
    after = document.project.face.layers.stiffness
    assert np.array_equal(after, while_held)
    assert heard == [("stiffness", tuple(np.flatnonzero(after != face.layers.stiffness)))]
    document.undo()
    assert document.project.face.layers.stiffness.tobytes() == face.layers.stiffness.tobytes()


def test_a_cancelled_stroke_puts_back_what_it_has_drawn(
    box: ToolBox, seen: list[Working], document: Document, project: Project
) -> None:
    box.press(on_skin(project.face, 0, 0))
    box.move(on_skin(project.face, 10, 10))
    assert box.cancel()
    assert not box.busy
    assert np.array_equal(drawn(project.face, "stiffness", seen), project.face.layers.stiffness)
    box.release(on_skin(project.face, 10, 10))
    assert document.project is project
    assert not box.cancel()


def test_undo_in_the_middle_of_a_stroke_lets_the_stroke_go(
    box: ToolBox, seen: list[Working], document: Document, project: Project
) -> None:
    document.set_weights({"17": 0.5})
    box.press(on_skin(project.face, 0, 0))
    document.undo()
    assert not box.busy
    assert np.array_equal(drawn(project.face, "stiffness", seen), project.face.layers.stiffness)
    box.release(on_skin(project.face, 0, 0))
    assert document.history.done == ()


def test_another_head_in_the_middle_of_a_stroke_ends_it(
    box: ToolBox, seen: list[Working], document: Document, project: Project, ada: Project
) -> None:
    box.press(on_skin(project.face, 20, 20))
    told = len(seen)
    document.restore(ada, None)
    assert not box.busy
    assert len(seen) == told
    box.move(Pointer(0, 0))
    box.release(Pointer(0, 0))
    assert document.history.done == ()


def test_a_stroke_beside_the_face_is_none(box: ToolBox, document: Document, project: Project) -> None:
    box.press(Pointer(0, 0))
    assert not box.busy
    box.release(Pointer(0, 0))
    assert document.project is project


def test_a_stroke_that_leaves_the_face_paints_nothing_between_where_it_left_and_came_back(
    box: ToolBox, document: Document, project: Project
) -> None:
    box.bench.brush.change(radius=8.0)
    rings: list[object] = []
    box.bench.sight.ring_changed.connect(rings.append)
    box.press(on_skin(project.face, -30, 0))
    box.move(Pointer(0, 0))
    assert rings[-1] is None
    box.move(on_skin(project.face, 30, 0))
    box.release(on_skin(project.face, 30, 0))
    x = project.face.skin.positions[:, 0]
    changed = document.project.face.layers.stiffness != project.face.layers.stiffness
    assert changed[x < -20].any()
    assert changed[x > 20].any()
    assert not changed[np.abs(x) < 15].any()
    assert len(document.history.done) == 1


def test_control_takes_away_what_was_added(box: ToolBox, document: Document, project: Project) -> None:
    box.bench.brush.set_mode("add")
    box.bench.brush.set_value(0.004)
    stroke(box, (0, 0), (10, 0))
    stroke(box, (0, 0), (10, 0), modifiers=frozenset({"control"}))
    assert document.project.face.layers.stiffness == pytest.approx(project.face.layers.stiffness, abs=1e-15)
    assert len(document.history.done) == 2


def test_shift_smooths(box: ToolBox, document: Document) -> None:
    stroke(box, (0, 0))
    rough = document.project.face.layers.stiffness
    box.bench.brush.change(radius=40.0)
    stroke(box, (0, 0), modifiers=frozenset({"shift"}))
    smooth = document.project.face.layers.stiffness
    assert document.history.done[-1] == "Smooth tissue stiffness"
    assert np.ptp(smooth) < np.ptp(rough)


def test_control_and_shift_pick_the_value_under_the_pointer(box: ToolBox, document: Document, project: Project) -> None:
    stroke(box, (0, 0))
    box.bench.brush.set_value(0.05)
    box.press(on_skin(project.face, 0, 0, modifiers=frozenset({"shift", "control"})))
    assert not box.busy
    assert box.bench.brush.state.value == pytest.approx(0.01)
    assert len(document.history.done) == 1


def test_a_mirrored_stroke_paints_both_sides_alike(box: ToolBox, document: Document, project: Project) -> None:
    box.bench.brush.change(mirror=True)
    stroke(box, (25, 5), (20, -10))
    painted = document.project.face.layers.stiffness
    assert (painted != project.face.layers.stiffness).any()
    assert np.array_equal(painted, painted[project.face.mirror])


def test_a_mirrored_stroke_on_a_face_without_symmetry_says_so_and_paints_nothing(project: Project) -> None:
    count = len(project.face.mirror)
    lopsided = replace(project.face, mirror=np.arange(count), skin=project.face.skin.moved(_askew(project.face)))
    document = Document(replace(project, face=lopsided))
    box = ToolBox(bench_for(document, "tissue"), TOOLS)
    box.take("brush")
    complaints: list[str] = []
    box.failed.connect(complaints.append)
    box.press(on_skin(lopsided, 20, 0))
    assert complaints
    assert "not symmetric" in complaints[0]
    assert not box.busy


def _askew(face: Face) -> FloatArray:
    x, y, z = face.skin.positions.T
    return np.column_stack([x + 0.8 * y, y, z])


def test_a_support_is_painted_wholly_or_not_at_all(box: ToolBox, document: Document, project: Project) -> None:
    box.bench.brush.change(layer="supports", strength=0.3, hardness=0.0)
    box.bench.brush.set_value(float(Support.SLIDING))
    stroke(box, (0, 0))
    painted = document.project.face.layers.supports
    changed = painted != project.face.layers.supports
    assert changed.any()
    assert set(painted[changed]) == {Support.SLIDING}


def test_a_lasso_selects_what_it_goes_round_and_the_brush_stays_inside(
    box: ToolBox, document: Document, project: Project
) -> None:
    box.take("lasso")
    for act, corner in zip(
        (box.press, box.move, box.move, box.release), [(85, 65), (85, 135), (135, 135), (135, 65)], strict=True
    ):
        act(Pointer(*corner))
    selected = box.bench.regions.selected(project.face)
    assert selected is not None
    x, y, _ = project.face.skin.positions.T
    assert np.array_equal(selected, (x > -15) & (x < 35) & (y > -35) & (y < 35))
    assert document.history.done == ()
    box.take("brush")
    stroke(box, (-30, 0), (30, 0))
    changed = document.project.face.layers.stiffness != project.face.layers.stiffness
    assert changed.any()
    assert not changed[~selected].any()


def test_a_click_with_the_lasso_deselects(box: ToolBox, project: Project) -> None:
    regions = box.bench.regions
    regions.select(project.face, np.ones(len(project.face.skin.positions), dtype=np.bool_))
    box.take("lasso")
    box.press(Pointer(10, 10))
    box.release(Pointer(10, 10))
    assert regions.selected(project.face) is None


def test_locked_vertices_keep_their_values_in_strokes_and_fills(
    box: ToolBox, document: Document, project: Project
) -> None:
    locked = project.face.skin.positions[:, 0] > 0
    box.bench.regions.lock(project.face, locked)
    stroke(box, (-20, 0), (20, 0))
    box.take("fill")
    stroke(box, (0, 20))
    changed = document.project.face.layers.stiffness != project.face.layers.stiffness
    assert changed[~locked].any()
    assert not changed[locked].any()


def test_a_fill_goes_as_far_as_the_values_are_alike(box: ToolBox, document: Document, project: Project) -> None:
    box.bench.brush.change(layer="supports")
    box.bench.brush.set_value(float(Support.VALUE))
    box.take("fill")
    rim = project.face.layers.supports == Support.CLAMPED
    stroke(box, (0, 0))
    painted = document.project.face.layers.supports
    assert (painted[~rim] == Support.VALUE).all()
    assert (painted[rim] == Support.CLAMPED).all()
    assert document.history.done == ("Fill supports",)


def test_the_tool_of_a_workspace_is_put_away_when_another_one_opens(
    box: ToolBox, seen: list[Working], document: Document, project: Project
) -> None:
    rings: list[object] = []
    box.bench.sight.ring_changed.connect(rings.append)
    box.press(on_skin(project.face, 0, 0))
    box.bench.view.change(workspace="muscles")
    assert not box.busy
    assert rings[-1] is None
    assert box.tool.id == "select"
    assert np.array_equal(drawn(project.face, "stiffness", seen), project.face.layers.stiffness)
    with pytest.raises(UnknownNameError, match="fibre"):
        box.take("brush")
    box.bench.view.change(workspace="tissue")
    assert box.tool.id == "brush"
    assert document.project is project


def test_the_ring_follows_pointer_and_radius(box: ToolBox, project: Project) -> None:
    rings: list[object] = []
    box.bench.sight.ring_changed.connect(rings.append)
    box.bench.brush.change(mirror=True)
    box.move(on_skin(project.face, 20, 0))
    ring = rings[-1]
    assert ring.radius == 15.0  # type: ignore[attr-defined]
    middle, image = ring.hit.position, ring.mirrored.position  # type: ignore[attr-defined]
    assert image == pytest.approx(middle * [-1, 1, 1], abs=0.5)
    box.bench.brush.resize(1)
    assert rings[-1].radius > 15.0  # type: ignore[attr-defined]
    box.leave()
    assert rings[-1] is None


@pytest.fixture(scope="module")
def ada() -> Project:
    return new_project()


@pytest.fixture
def lab(ada: Project) -> ToolBox:
    return ToolBox(bench_for(Document(ada), "muscles"), TOOLS)


def bone_hit(face: Face, near: FloatArray) -> Hit:
    middles = face.skull.cranium.positions[face.skull.cranium.triangles].mean(axis=1)
    triangle = int(np.argmin(np.linalg.norm(middles - near, axis=1)))
    return skull_hit(face, "cranium", triangle, np.full(3, 1 / 3))


def face_hit(face: Face, landmark: str) -> Hit:
    vertex = face.landmarks[landmark]
    triangle = int(np.flatnonzero((face.skin.triangles == vertex).any(axis=1))[0])
    shares = np.where(face.skin.triangles[triangle] == vertex, 0.9, 0.05)
    return skin_hit(face, triangle, shares)


def test_a_fibre_is_laid_from_the_bone_to_the_skin_on_both_sides(lab: ToolBox, ada: Project) -> None:
    face, document = ada.face, lab.bench.document
    ghosts: list[object] = []
    lab.bench.sight.ghost_changed.connect(ghosts.append)
    lab.take("fibre")
    start, end = bone_hit(face, face.skin.positions[face.landmarks["zygion_L"]]), face_hit(face, "mouth_corner_L")
    lab.press(Pointer(0, 0, skull=start))
    lab.move(Pointer(50, 50, skin=end))
    assert ghosts[-1].influence.max() == pytest.approx(1.0)  # type: ignore[attr-defined]
    assert document.project is ada
    lab.release(Pointer(50, 50, skin=end))
    laid = document.project.muscles[len(ada.muscles) :]
    assert [muscle.side for muscle in laid] == ["L", "R"]
    assert laid[0].group == "lip"
    assert laid[0].fibres[0].attachment == pytest.approx(face.skin.positions[face.landmarks["mouth_corner_L"]])
    assert laid[1].fibres[0].attachment == pytest.approx(face.skin.positions[face.landmarks["mouth_corner_R"]])
    assert lab.bench.view.state.muscle == laid[0].key
    assert len(document.history.done) == 1
    document.undo()
    assert document.project.muscles == ada.muscles


def test_an_end_of_a_selected_muscle_is_dragged_and_its_partner_follows(lab: ToolBox, ada: Project) -> None:
    face, document = ada.face, lab.bench.document
    changed: list[frozenset[str]] = []
    document.muscles_changed.connect(changed.append)
    lab.bench.view.change(muscle="zygomaticus_major_L")
    lab.take("fibre")
    muscle = next(each for each in ada.muscles if each.key == "zygomaticus_major_L")
    end = next(handle for handle in handles(muscle, face) if handle.part == "attachment")
    on_it = Pointer(0, 0, ray=facing(end.point))
    lab.press(on_it)
    assert lab.busy
    to = face_hit(face, "cheek_L")
    lab.move(Pointer(9, 9, skin=to))
    lab.release(Pointer(9, 9, skin=to))
    assert changed == [frozenset({"zygomaticus_major_L", "zygomaticus_major_R"})]
    assert len(document.project.muscles) == len(ada.muscles)
    moved = next(each for each in document.project.muscles if each.key == "zygomaticus_major_R")
    assert moved.fibres[end.fibre].attachment == pytest.approx(face.skin.positions[face.landmarks["cheek_R"]])


def test_a_fibre_is_bent_where_it_is_taken(lab: ToolBox, ada: Project) -> None:
    document = lab.bench.document
    lab.bench.view.change(muscle="zygomaticus_major_L")
    lab.take("fibre")
    muscle = next(each for each in ada.muscles if each.key == "zygomaticus_major_L")
    middle = muscle.fibres[0].points.mean(axis=0)
    lab.press(Pointer(0, 0, ray=facing(middle), modifiers=frozenset({"control"})))
    lab.move(Pointer(0, 9, ray=facing(middle + UP)))
    lab.release(Pointer(0, 9, ray=facing(middle + UP)))
    bent = next(each for each in document.project.muscles if each.key == "zygomaticus_major_L")
    (via,) = [point for fibre in bent.fibres for point in fibre.via]
    assert via[:2] == pytest.approx((middle + UP)[:2])


def test_a_cancelled_drag_of_a_muscle_leaves_no_trace(lab: ToolBox, ada: Project) -> None:
    ghosts: list[object] = []
    lab.bench.sight.ghost_changed.connect(ghosts.append)
    lab.take("fibre")
    lab.press(Pointer(0, 0, skull=bone_hit(ada.face, ada.face.skin.positions[ada.face.landmarks["zygion_L"]])))
    lab.move(Pointer(5, 5, skin=face_hit(ada.face, "cheek_L")))
    lab.cancel()
    assert ghosts[-1] is None
    assert lab.bench.document.project is ada


def test_a_fibre_that_cannot_be_laid_says_why(lab: ToolBox, ada: Project) -> None:
    complaints: list[str] = []
    lab.failed.connect(complaints.append)
    ghosts: list[object] = []
    lab.bench.sight.ghost_changed.connect(ghosts.append)
    lab.take("fibre")
    fibre = lab.tool
    assert isinstance(fibre, FibreTool)
    fibre.bone_snap = fibre.skin_snap = "free"
    place = face_hit(ada.face, "cheek_L")
    lab.press(Pointer(0, 0, skull=place))
    lab.move(Pointer(0, 0, skin=place))
    assert "one point" in ghosts[-1].complaint  # type: ignore[attr-defined]
    lab.release(Pointer(0, 0, skin=place))
    assert "one point" in complaints[0]
    assert lab.bench.document.project is ada
    air = replace(place, position=place.position + BEFORE_THE_FACE)
    lab.press(Pointer(0, 0, skull=air))
    lab.move(Pointer(0, 0, skin=place))
    lab.release(Pointer(0, 0, skin=place))
    assert "outside the head" in complaints[1]
    assert lab.bench.document.project is ada


def test_locked_muscles_stay_where_they_are(lab: ToolBox, ada: Project) -> None:
    muscle = next(each for each in ada.muscles if each.key == "zygomaticus_major_L")
    lab.bench.view.change(muscle=muscle.key, locked=frozenset({muscle.key}))
    lab.take("fibre")
    lab.press(Pointer(0, 0, ray=facing(muscle.fibres[0].attachment)))
    assert not lab.busy


def test_a_click_selects_a_muscle_and_shift_several(lab: ToolBox, ada: Project) -> None:
    view = lab.bench.view
    named: list[str] = []
    lab.bench.sight.pointed_changed.connect(named.append)

    def over(key: str) -> Ray:
        muscle = next(each for each in ada.muscles if each.key == key)
        return facing(muscle.fibres[0].points.mean(axis=0))

    first = Pointer(0, 0, ray=over("frontalis_medialis_L"))
    lab.move(first)
    assert named == ["frontalis_medialis_L"]
    lab.press(first)
    lab.press(Pointer(0, 0, ray=over("frontalis_lateralis_R"), modifiers=frozenset({"shift"})))
    assert view.state.selected == {"frontalis_medialis_L", "frontalis_lateralis_R"}
    lab.press(Pointer(0, 0))
    assert view.state.selected == frozenset()


@pytest.mark.parametrize(
    ("landmark", "group"),
    [("brow_mid_L", "brow"), ("mouth_corner_R", "lip"), ("chin", "chin"), ("nose_tip", "nose"), ("cheek_L", "cheek")],
)
def test_a_new_muscle_belongs_to_the_part_of_the_face_it_ends_in(ada: Project, landmark: str, group: str) -> None:
    assert group_at(ada.face, ada.face.skin.positions[ada.face.landmarks[landmark]]) == group


def test_the_step_of_a_stroke_keeps_only_what_it_painted(box: ToolBox, document: Document, project: Project) -> None:
    stroke(box, (0, 0))
    step = document.history.to_undo
    assert isinstance(step, PaintLayers)
    (rows,) = step.rows
    assert len(rows.indices) < len(project.face.skin.positions) / 2
    assert step.cost < 24 * len(rows.indices) + 100
