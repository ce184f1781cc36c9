"""Facts about the picture, pixel by pixel, and about what overlays leave behind."""

from collections.abc import Iterator

import numpy as np
import pytest
import pyvista as pv

from app.view_state import ViewState
from facemodel.sampling import points_of_vertices
from tests.ui.sitter import OPEN, SMILE, around, sitter, studio, weights
from ui.headless.stage import stage
from ui.viewport.complexion import openings
from ui.viewport.figure import Figure
from ui.viewport.neck import neck_cut
from ui.viewport.overlays.overlay import Overlay
from ui.viewport.scene import Scene

OVERLAYS = ("skull", "muscles", "forces", "supports", "wireframe")


@pytest.fixture
def scene() -> Iterator[Scene]:
    """The studio's scene from the front, at rest, and so again afterwards."""
    made = studio().scene
    made.look_from("front")
    yield made
    made.glow(frozenset())
    made.apply(ViewState())
    made.pose({})


@pytest.fixture
def figure(scene: Scene) -> Figure:
    assert scene.figure is not None
    return scene.figure


def props(scene: Scene) -> list[object]:
    held = scene.renderer.GetViewProps()
    return [held.GetItemAsObject(k) for k in range(held.GetNumberOfItems())]


def mark(name: str, up: float = 0.0, left: float = 0.0) -> np.ndarray:
    """A landmark, or a place some millimetres above it or to the subject's left of it."""
    face = sitter()[0].face
    return face.skin.positions[face.landmarks[name]] + np.array([left, up, 0.0])


def test_nothing_is_looked_for_that_is_out_of_the_picture() -> None:
    plotter = pv.Plotter(off_screen=True)
    assert Scene(plotter).renderer.GetCullers().GetNumberOfItems() == 0
    plotter.close()


def test_pupils_are_dark_and_the_white_beside_them_is_bright(scene: Scene) -> None:
    picture = studio().picture()
    for eye in sitter()[0].face.eyes:
        front = eye.centre + np.array([0, -1.2, eye.radius])
        assert around(picture, front, 0).mean() < 0.15
        out = 1.0 if eye.side == "L" else -1.0
        white = eye.centre + np.array([8.5 * out, -0.5, np.sqrt(eye.radius**2 - 8.5**2)])
        assert around(picture, white, 1).max() > 0.5


def test_a_light_is_mirrored_in_both_eyes(scene: Scene) -> None:
    picture = studio().picture()
    for eye in sitter()[0].face.eyes:
        assert around(picture, eye.centre + np.array([0, 0, eye.radius]), 5).min(axis=2).max() > 0.6


def test_lips_are_redder_than_the_skin_around_them(scene: Scene) -> None:
    picture = studio().picture()

    def redness(name: str) -> float:
        red, green, blue = around(picture, mark(name), 1).reshape(-1, 3).mean(axis=0)
        return float(red / (green + blue))

    assert redness("lower_lip_incisor") > 1.1 * redness("pogonion")
    assert redness("lower_lip_incisor") > 1.1 * redness("glabella")


def test_brows_are_darker_than_the_forehead_above_and_the_lid_below(scene: Scene) -> None:
    picture = studio().picture()
    for side in "LR":
        brow = around(picture, mark(f"brow_mid_{side}", -0.5), 1).mean()
        assert brow < 0.9 * around(picture, mark(f"brow_mid_{side}", 12), 1).mean()
        assert brow < 0.95 * around(picture, mark(f"brow_mid_{side}", -9), 1).mean()


def test_brows_ride_on_the_skin(scene: Scene) -> None:
    still = studio().picture()
    scene.pose(weights(au1=1.0, au2=1.0))
    raised = studio().picture()
    for side in "LR":
        low, high = mark(f"brow_mid_{side}"), mark(f"brow_mid_{side}", 6)
        assert around(raised, low, 1).mean() > around(still, low, 1).mean() + 0.05
        assert around(raised, high, 2).min() < around(still, high, 2).min() - 0.05


def test_a_smile_changes_the_mouth_corners_and_not_the_crown(scene: Scene) -> None:
    still = studio().picture()
    scene.pose(weights(**SMILE))
    smiling = studio().picture()
    for side in "LR":
        change = np.abs(
            around(smiling, mark(f"mouth_corner_{side}"), 6) - around(still, mark(f"mouth_corner_{side}"), 6)
        )
        assert change.max() > 0.2
    top = sitter()[0].face.skin.positions[:, 1].max()
    crown = np.array([0.0, top - 12.0, 0.0])
    assert np.abs(around(smiling, crown, 8) - around(still, crown, 8)).max() < 2 / 255


def test_an_open_jaw_shows_a_dark_mouth(scene: Scene) -> None:
    still = studio().picture()
    scene.pose(weights(**OPEN))
    opened = studio().picture()
    inside = (mark("upper_lip_mid", -8) + mark("lower_lip_mid", -8)) / 2
    assert around(opened, inside, 2).mean() < 0.6 * around(still, inside, 2).mean()


def test_the_inside_of_parted_lips_comes_to_light_and_lies_in_shade_again(scene: Scene, figure: Figure) -> None:
    face, display = sitter()[0].face, figure.posed.basis.display
    lips = points_of_vertices(face, display)[openings(face)[0]]
    colours = figure.skin.surface.colours
    assert colours is not None
    rest = colours.copy()
    scene.pose(weights(**OPEN))
    assert colours[lips, 3].mean() > 1.3 * rest[lips, 3].mean()
    assert (colours[:, 3] >= rest[:, 3]).all()
    assert np.array_equal(colours[:, :3], rest[:, :3])
    scene.pose({})
    assert np.array_equal(colours, rest)


def test_the_strip_along_the_cut_of_the_neck_goes_along_with_the_skin(scene: Scene, figure: Figure) -> None:
    cut = neck_cut(figure.posed.basis.display)
    assert cut is not None
    assert figure.skin.hem is not None
    whole = cut.start == cut.stop
    scene.pose(weights(**OPEN))
    assert np.allclose(figure.skin.hem.points[whole], figure.posed.points[cut.start[whole]], atol=2e-2)


def test_the_same_pose_gives_the_same_picture_whatever_was_shown_between(scene: Scene) -> None:
    first = studio().picture()
    scene.pose(weights(**SMILE))
    scene.apply(ViewState(skull=True, muscles=True))
    studio().picture()
    scene.apply(ViewState())
    scene.pose({})
    assert np.array_equal(studio().picture(), first)


def test_the_neutral_face_is_shown_before_anything_is_solved(scene: Scene) -> None:
    solved = studio().picture()
    with stage((360, 420), samples=0) as other:
        other.scene.show(sitter()[0])
        other.scene.look_from("front")
        unsolved = other.picture()
    difference = np.abs(unsolved.astype(int) - solved.astype(int))
    assert np.quantile(difference, 0.999) <= 2


@pytest.mark.parametrize("name", OVERLAYS)
def test_an_overlay_adds_its_own_actors_and_takes_exactly_those_away(scene: Scene, name: str) -> None:
    before, picture = props(scene), studio().picture()
    scene.apply(ViewState(**{name: True}))
    scene.pose(weights(**SMILE))
    during = props(scene)
    assert during[: len(before)] == before
    assert len(during) > len(before)
    studio().picture()
    scene.apply(ViewState())
    scene.pose({})
    assert props(scene) == before
    assert np.array_equal(studio().picture(), picture)


@pytest.mark.parametrize("name", OVERLAYS)
def test_an_overlay_is_seen(scene: Scene, name: str) -> None:
    scene.pose(weights(**SMILE))
    bare = studio().picture()
    scene.apply(ViewState(**{name: True}))
    assert np.count_nonzero(np.abs(studio().picture().astype(int) - bare).max(axis=2) > 20) > 40


def test_overlays_follow_a_new_solution_without_leaving_anything(scene: Scene) -> None:
    project, solution = sitter()
    scene.apply(ViewState(**dict.fromkeys(OVERLAYS, True)))
    count = len(props(scene))
    scene.show(project, solution)
    assert len(props(scene)) == count
    scene.apply(ViewState())
    assert scene.figure is not None
    assert props(scene) == list(scene.figure.actors)


def test_the_mandible_turns_with_the_jaw(scene: Scene, figure: Figure) -> None:
    scene.apply(ViewState(skull=True))
    _, mandible = props(scene)[-2:]
    scene.pose(weights(**OPEN))
    low = mandible.GetBounds()[2]
    scene.pose({})
    assert mandible.GetBounds()[2] > low + 10
    assert np.allclose(figure.posed.jaw, np.eye(4))


def test_a_contracting_muscle_glows_and_the_others_do_not(scene: Scene) -> None:
    scene.apply(ViewState(muscles=True))
    (bands,) = props(scene)[-1:]
    scalars = bands.GetMapper().GetInput().GetPointData().GetScalars()
    owner = muscles_overlay(scene)._owner
    keys = [muscle.key for muscle in sitter()[0].muscles]

    def light(key: str) -> float:
        chosen = np.flatnonzero(owner == keys.index(key))
        return float(np.mean([sum(scalars.GetTuple(int(k))[:3]) for k in chosen]))

    rest = {key: light(key) for key in ("zygomaticus_major_L", "frontalis_medialis_L")}
    scene.pose(weights(au12=1.0))
    assert light("zygomaticus_major_L") > 1.3 * rest["zygomaticus_major_L"]
    assert light("frontalis_medialis_L") == rest["frontalis_medialis_L"]


def muscles_overlay(scene: Scene) -> Overlay:
    return scene.overlays.by_name["muscles"]


def test_forces_stand_on_the_skin_and_grow_with_the_picture(scene: Scene, figure: Figure) -> None:
    scene.apply(ViewState(forces=True))
    scene.pose(weights(au12=1.0))
    arrows = props(scene)[-1]

    def size() -> float:
        scene.before_frame()
        points = arrows.GetMapper().GetInput()
        shafts = [np.array(points.GetPoint(k)) for k in (0, 15)]
        return float(np.linalg.norm(shafts[0] - shafts[1]))

    far = size()
    scene.renderer.GetActiveCamera().Dolly(2.0)
    assert size() == pytest.approx(far / 2, rel=0.05)
    scene.pose({})
    assert size() == 0.0


def test_influence_colours_the_skin_where_the_muscle_pulls_with_a_legend(scene: Scene) -> None:
    before, bare = props(scene), studio().picture()
    scene.apply(ViewState(influence=True, muscle="zygomaticus_major_L"))
    coloured = studio().picture()
    (bar,) = props(scene)[len(before) :]
    assert bar.GetClassName() == "vtkScalarBarActor"
    assert "kPa" in bar.GetTitle()
    left, right = (mark(f"mouth_corner_{side}", 4, 5 * sign) for side, sign in (("L", 1), ("R", -1)))
    assert np.abs(around(coloured, left, 2) - around(bare, left, 2)).mean() > 0.04
    assert np.array_equal(around(coloured, right, 2), around(bare, right, 2))


def test_what_is_under_the_pointer_glows_and_stops_glowing(scene: Scene) -> None:
    bare = studio().picture()
    scene.glow(frozenset({"zygomaticus_major_L"}))
    assert np.abs(studio().picture().astype(int) - bare).max() > 20
    scene.glow(frozenset())
    assert np.array_equal(studio().picture(), bare)


def test_a_muscle_can_be_brought_near(scene: Scene) -> None:
    camera = scene.renderer.GetActiveCamera()
    before = camera.GetDistance()
    scene.frame_muscle("frontalis_medialis_L")
    assert camera.GetDistance() < 0.7 * before
    assert camera.GetFocalPoint()[1] > mark("brow_mid_L")[1] - 15
    assert camera.GetFocalPoint()[0] > 5


def test_turning_the_table_goes_round_the_head(scene: Scene) -> None:
    camera = scene.renderer.GetActiveCamera()
    distance = np.linalg.norm(np.array(camera.GetPosition()) - scene.pivot)
    scene.turn(90.0)
    assert camera.GetPosition()[0] > 0.9 * distance


def test_the_light_theme_has_a_light_backdrop_a_little_lighter_in_the_middle(scene: Scene) -> None:
    dark = studio().picture()
    scene.dress("light")
    light = studio().picture()
    scene.dress("dark")
    assert dark[:4, :4].mean() < 70
    assert light[:4, :4].mean() > 150
    for picture in (dark, light):
        assert picture[200:220, :10].mean() > picture[:10, :10].mean()
