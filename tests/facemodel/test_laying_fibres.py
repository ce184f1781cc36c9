"""Fibres and rings laid and dragged: what was moved back is what it was."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.laying.fibres import (
    added_fibre,
    bent,
    laid_fibre,
    removed_fibre,
    reordered,
    with_end,
    with_via,
    without_via,
)
from facemodel.laying.handles import Handle, dragged, handles
from facemodel.laying.places import kind_of_place, nearest
from facemodel.laying.rings import laid_ring, sector_of, with_axis, with_centre, with_length, with_sector
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.muscles.models import MODELS
from facemodel.muscles.mouth import PROFILES
from facemodel.project import Project
from fem.types import FloatArray
from tests.facemodel.skin import by, fibre_muscle, ring_muscle
from tests.io.small_project import identical

numbers = st.floats(-50, 50)
points = st.tuples(numbers, numbers, numbers).map(lambda xyz: np.array(xyz, dtype=np.float64))
ROW = [([0.0, 0, 0], [10.0, 0, 0]), ([0.0, 4, 0], [10.0, 4, 0]), ([0.0, 8, 0], [10.0, 8, 0])]
FLAT_RING = Sphincter(np.zeros(3), np.array([16.0, 0, 0]), np.array([0, 10.0, 0]))


def zygomaticus(project: Project) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == "zygomaticus_major_L")


def test_a_fibre_is_laid_from_the_bone_to_a_vertex(face: Face) -> None:
    cheek, corner = (face.skin.positions[face.landmarks[name]] for name in ("cheek_L", "mouth_corner_L"))
    fibre = laid_fibre(face, cheek, corner + by(0.4, 0.3, 0.2))
    assert kind_of_place(face, fibre.attachment)[0] == "vertex"
    away = [nearest(mesh, fibre.origin)[2][0] for mesh in (face.skull.cranium, face.skull.mandible)]
    assert min(away) < 1e-9
    slid = laid_fibre(face, cheek, corner + by(0.4, 0.3, 0.2), skin="surface")
    assert nearest(face.skin, slid.attachment)[2][0] < 1e-9


@given(st.integers(0, 2), st.sampled_from(["origin", "attachment"]), points)
def test_an_end_that_is_moved_back_leaves_the_muscle_as_it_was(number: int, end: str, to: FloatArray) -> None:
    muscle = fibre_muscle(ROW)
    moved = with_end(muscle, number, end, to)  # type: ignore[arg-type]
    assert np.array_equal(getattr(moved.fibres[number], end), to)
    back = with_end(moved, number, end, getattr(muscle.fibres[number], end))  # type: ignore[arg-type]
    assert identical(back, muscle)


@given(st.integers(0, 2), points, points)
def test_a_bend_that_is_taken_out_leaves_the_fibre_straight(number: int, first: FloatArray, to: FloatArray) -> None:
    muscle = fibre_muscle(ROW)
    curved, place = bent(muscle, number, first)
    assert np.array_equal(curved.fibres[number].via[place], first)
    elsewhere = with_via(curved, number, place, to)
    assert np.array_equal(elsewhere.fibres[number].via[place], to)
    assert identical(with_via(elsewhere, number, place, first), curved)
    assert identical(without_via(elsewhere, number, place), muscle)


def test_intermediate_points_come_in_the_order_of_the_fibre() -> None:
    muscle = fibre_muscle([([0.0, 0, 0], [10.0, 0, 0])])
    for x in (7.0, 3.0, 5.0, 9.0):
        muscle, place = bent(muscle, 0, np.array([x, 1.0, 0]))
        assert muscle.fibres[0].via[place][0] == x
    assert [point[0] for point in muscle.fibres[0].via] == [3, 5, 7, 9]


@pytest.mark.parametrize(("y", "slot"), [(-3.0, 0), (2.0, 1), (5.0, 2), (12.0, 3)])
def test_a_new_fibre_takes_its_place_in_the_spine(y: float, slot: int) -> None:
    fibre = Fibre(np.array([0.0, y, 0]), np.array([10.0, y, 0]))
    grown = added_fibre(fibre_muscle(ROW), fibre)
    assert grown.fibres[slot] is fibre
    assert identical(removed_fibre(grown, slot), fibre_muscle(ROW))
    assert added_fibre(replace(fibre_muscle(ROW), fibres=()), fibre).fibres == (fibre,)


@pytest.mark.parametrize(
    ("act", "says"),
    [
        (lambda m: with_end(m, 3, "origin", np.zeros(3)), "has no fibre 4; it has 3"),
        (lambda m: with_via(m, 0, 0, np.zeros(3)), "has no intermediate point 1; it has 0"),
        (lambda m: without_via(m, 1, -1), "no intermediate point 0"),
        (lambda m: removed_fibre(replace(m, fibres=m.fibres[:1]), 0), "delete the muscle instead"),
        (lambda m: with_centre(m, np.zeros(3)), "has no ring; draw an ellipse"),
    ],
)
def test_what_is_not_there_cannot_be_moved(act: object, says: str) -> None:
    with pytest.raises(MuscleError, match=says):
        act(fibre_muscle(ROW))  # type: ignore[operator]


def test_a_ring_is_laid_as_the_skin_lies(face: Face) -> None:
    cheek = face.landmarks["cheek_L"]
    centre, normal = face.skin.positions[cheek], face.skin.normals[cheek]
    ring = laid_ring(face, centre, centre + by(-12.0, 2, 0), 7.0)
    assert np.linalg.norm(ring.short_axis) == pytest.approx(7.0)
    assert ring.long_axis @ ring.short_axis == pytest.approx(0.0, abs=1e-9)
    outward = np.cross(ring.long_axis, ring.short_axis)
    assert outward / np.linalg.norm(outward) == pytest.approx(normal)
    with pytest.raises(MuscleError, match="needs a width and a height"):
        laid_ring(face, centre, centre, 7.0)
    with pytest.raises(MuscleError, match="needs a width and a height"):
        laid_ring(face, centre, centre + by(5.0, 0, 0), 0.0)


@given(points.filter(lambda p: np.linalg.norm(p) > 1 and p[0] > -0.9 * np.linalg.norm(p)))
def test_a_dragged_half_axis_keeps_the_other_square_and_comes_back(tip: FloatArray) -> None:
    muscle = ring_muscle(FLAT_RING)
    moved = with_axis(muscle, "long", tip)
    assert moved.ring is not None
    assert np.array_equal(moved.ring.long_axis, tip)
    assert np.linalg.norm(moved.ring.short_axis) == pytest.approx(10.0)
    assert moved.ring.short_axis @ tip == pytest.approx(0.0, abs=1e-9 * np.linalg.norm(tip))
    back = with_axis(moved, "long", FLAT_RING.long_axis)
    assert back.ring is not None
    assert back.ring.short_axis == pytest.approx(FLAT_RING.short_axis, abs=1e-7)


def test_an_axis_can_be_drawn_through_the_middle_and_not_onto_it() -> None:
    turned = with_axis(ring_muscle(FLAT_RING), "short", np.array([0.0, -4.0, 0]))
    assert turned.ring is not None
    assert turned.ring.long_axis == pytest.approx(-FLAT_RING.long_axis), "it still faces outward"
    with pytest.raises(MuscleError, match="drag its tip away from its middle"):
        with_axis(ring_muscle(FLAT_RING), "short", np.zeros(3))


def of_model(project: Project, model: str) -> Muscle:
    key = "zygomaticus_major_L" if MODELS[model].geometry == "fibres" else "orbicularis_oculi_orbitalis_L"  # type: ignore[index]
    muscle = next(each for each in project.muscles if each.key == key)
    return replace(muscle, model=model)  # type: ignore[arg-type]


@pytest.mark.parametrize("model", [name for name in MODELS if name != "jaw"])
def test_a_handle_that_is_dragged_to_where_it_is_changes_nothing_that_acts(project: Project, model: str) -> None:
    face, muscle = project.face, of_model(project, model)
    for handle in handles(muscle, face):
        same = dragged(muscle, handle, handle.point, face, bone="free", skin="free")
        for before, after in zip(handles(muscle, face), handles(same, face), strict=True):
            assert (before.part, before.fibre, before.place) == (after.part, after.fibre, after.place)
            assert after.point == pytest.approx(before.point, abs=1e-6)


@settings(max_examples=20)
@given(st.integers(0, 10**6))
def test_a_dragged_handle_goes_where_it_is_dragged_or_snaps(project: Project, seed: int) -> None:
    face, rng = project.face, np.random.default_rng(seed)
    muscle, _ = bent(zygomaticus(project), 1, np.array([40.0, -30.0, 35.0]))
    found = handles(muscle, face)
    handle = found[rng.integers(len(found))]
    to = handle.point + rng.uniform(-6, 6, 3)
    after = handles(dragged(muscle, handle, to, face), face)[found.index(handle)].point
    if handle.part == "origin":
        assert min(nearest(mesh, after)[2][0] for mesh in (face.skull.cranium, face.skull.mandible)) < 1e-9
    elif handle.part == "attachment":
        assert kind_of_place(face, after)[0] == "vertex"
    elif handle.part == "via":
        assert np.array_equal(after, to)


def test_a_radius_handle_sets_the_width_within_its_range(project: Project) -> None:
    face, muscle = project.face, zygomaticus(project)
    radii = [handle for handle in handles(muscle, face) if handle.part == "radius"]
    assert [handle.fibre for handle in radii] == [0, 2]
    attachment = muscle.fibres[2].attachment
    assert dragged(muscle, radii[1], attachment + by(0, 20.0, 0), face).width == pytest.approx(20.0)
    assert dragged(muscle, radii[1], attachment, face).width == 1.0
    assert dragged(muscle, radii[1], attachment + by(0, 500.0, 0), face).width == 60.0


def test_a_box_handle_sets_one_side_of_the_box(project: Project) -> None:
    face = project.face
    muscle = of_model(project, "cosine")
    boxes = [handle for handle in handles(muscle, face) if handle.part == "box"]
    assert [handle.place for handle in boxes] == [0, 1, 2]
    changed = dragged(muscle, boxes[1], muscle.fibres[0].attachment + by(3.0, -17.0, 4.0), face)
    assert changed.cosine is not None
    assert changed.cosine.box == pytest.approx([muscle.width, 17.0, muscle.width])


def test_a_central_fibre_takes_another_place_in_the_fan() -> None:
    muscle = fibre_muscle(ROW)
    turned = reordered(muscle, 0, 2)
    assert [float(fibre.origin[1]) for fibre in turned.fibres] == [4.0, 8.0, 0.0]
    assert identical(reordered(turned, 2, 0), muscle)
    assert identical(reordered(muscle, 0, -5), muscle), "there is nothing before the first"


def test_a_half_axis_takes_a_length_and_a_ring_a_half() -> None:
    muscle = ring_muscle(FLAT_RING)
    longer = with_length(muscle, "long", 24.0)
    assert longer.ring is not None
    assert longer.ring.long_axis == pytest.approx([24.0, 0, 0])
    assert np.array_equal(longer.ring.short_axis, FLAT_RING.short_axis)
    with pytest.raises(MuscleError, match="as thin as that"):
        with_length(muscle, "short", 0.0)
    for name, way in (("left", [1, 0, 0]), ("right", [-1, 0, 0]), ("up", [0, 1, 0]), ("down", [0, -1, 0])):
        half = with_sector(muscle, name)  # type: ignore[arg-type]
        assert half.ring is not None
        assert half.ring.sector == pytest.approx(way)
        assert sector_of(half) == name
    assert sector_of(with_sector(muscle, "whole")) == "whole"


def test_the_reach_of_a_mouth_draws_both_profiles_out(project: Project) -> None:
    face, muscle = project.face, of_model(project, "mouth")
    ring = muscle.ring
    assert ring is not None
    (reach,) = [handle for handle in handles(muscle, face) if handle.part == "reach"]
    drawn = dragged(muscle, reach, ring.centre + 2.5 * ring.long_axis, face)
    assert drawn.profiles is not None
    assert drawn.profiles.sigma.at[-1] == drawn.profiles.tau.at[-1] == pytest.approx(2.5)
    assert drawn.profiles.sigma.values == PROFILES.sigma.values
    far = dragged(muscle, reach, ring.centre + 9.0 * ring.long_axis, face)
    assert far.profiles is not None
    assert far.profiles.sigma.at[-1] == pytest.approx(3.0), "no further than a profile can be drawn"


def test_a_share_handle_is_where_the_attachment_goes(project: Project) -> None:
    face, muscle = project.face, of_model(project, "cosine")
    (share,) = [handle for handle in handles(muscle, face) if handle.part == "share"]
    fibre = muscle.fibres[0]
    half = dragged(muscle, share, (fibre.origin + fibre.attachment) / 2, face)
    assert half.cosine is not None
    assert half.cosine.share == pytest.approx(0.5)


def test_a_factor_handle_is_where_the_tip_of_the_ring_goes(project: Project) -> None:
    face, muscle = project.face, of_model(project, "cosine_ring")
    ring = muscle.ring
    assert ring is not None
    factors = [handle for handle in handles(muscle, face) if handle.part == "factor"]
    assert [handle.place for handle in factors] == [0, 1, 2]
    wider = dragged(muscle, factors[0], ring.centre - 1.5 * ring.long_axis, face)
    assert wider.cosine is not None
    assert wider.cosine.factors == pytest.approx([-0.5, 0.4, 0.0]), "it widens along the ring and narrows across it"


def test_the_arrow_of_the_jaw_is_its_force(face: Face) -> None:
    jaw = Muscle("jaw", "M", "Opening", "chin", "jaw", (), None, 10.0, 1.0, 0.01, 1)
    (arrow,) = handles(jaw, face)
    assert arrow.part == "force"
    teeth = face.skull.jaw.teeth
    stronger = dragged(jaw, arrow, teeth + 2 * (arrow.point - teeth), face)
    assert stronger.strength == pytest.approx(0.04), "twice as long is four times as strong"
    assert dragged(jaw, arrow, teeth + by(0, 50.0, 0), face).strength == 0.0, "it only opens"
    with pytest.raises(MuscleError, match="no fibre 1"):
        dragged(jaw, Handle("attachment", np.zeros(3)), np.zeros(3), face)
