"""What is seen is kept apart from what is undone."""

from app.sides import both_sides, other_side
from app.view import View
from app.view_state import ViewState
from facemodel.project import Project


def test_only_differences_are_told() -> None:
    view = View()
    heard: list[tuple[ViewState, ViewState]] = []
    view.changed.connect(lambda now, before: heard.append((now, before)))
    view.change(skull=True)
    view.change(skull=True)
    view.toggle("skull")
    assert [(now.skull, before.skull) for now, before in heard] == [(True, False), (False, True)]


def test_a_view_can_be_asked_for_twice_and_stops_the_turntable() -> None:
    view = View()
    asked: list[str] = []
    view.camera_asked.connect(asked.append)
    view.change(turntable=True)
    view.look_from("front")
    view.look_from("front")
    assert asked == ["front", "front"]
    assert view.state == ViewState(view="front", turntable=False)


def test_linked_sides_move_together_and_a_named_side_keeps_its_own(project: Project) -> None:
    units = project.units
    assert other_side("12L", units) == "12R"
    assert other_side("12R", units) == "12L"
    assert other_side("17", units) is None
    assert both_sides({"12L": 0.5, "17": 0.1}, units, linked=True) == {"12L": 0.5, "12R": 0.5, "17": 0.1}
    assert both_sides({"12L": 0.5}, units, linked=False) == {"12L": 0.5}
    assert both_sides({"12L": 0.5, "12R": 0.2}, units, linked=True) == {"12L": 0.5, "12R": 0.2}
