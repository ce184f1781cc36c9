"""Five hundred commands of every kind, undone to a document that is the same to the bit, and done again."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from app.authoring import emotions, motions, pad, parting, sculpting, units
from app.authoring.jaw import with_jaw_axis
from app.authoring.merging import merged
from app.authoring.mirroring import mirrored_unit
from app.authoring.skull import with_jaw_region, with_pose
from app.commands import ReplaceProject
from app.commands.corrections import set_corrections
from app.document import Document
from app.errors import NumberError, UnitError
from app.expression_clipboard import expressions_of, expressions_text, with_pasted
from app.scripting import run_script
from app.tools import TOOLS, Bench, Pointer, ToolBox, skin_hit
from app.view import View
from facemodel.animation.clip import Animation
from facemodel.animation.editing import bulk, dense, expressions, marks
from facemodel.animation.editing.selection import selected
from facemodel.animation.library import library, placed
from facemodel.cache import solution_key
from facemodel.errors import SkullError
from facemodel.face import Pose
from facemodel.io.animation import animation_arrays, animation_json
from facemodel.io.project_file import project_bytes, project_of
from facemodel.laying import collection
from facemodel.laying.fibres import added_fibre, bent, reordered, with_end
from facemodel.laying.sides import put
from facemodel.laying.values import changed, coloured, with_model
from facemodel.muscles import Fibre, Muscle
from facemodel.muscles.models import comparable_models
from facemodel.painting.brush import MODES
from facemodel.painting.layers import LAYER
from facemodel.project import Project
from facemodel.sculpting.correction import correction_of
from facemodel.skull.jaw_region import whole_skull

COMMANDS = 500
SEED = 1998


class Hands:
    """A person who does one thing after the other, at random but always the same."""

    def __init__(self, document: Document, seed: int) -> None:
        self.document = document
        self.random = np.random.default_rng(seed)
        view = View()
        view.change(workspace="tissue")
        self.box = ToolBox(Bench(document, view), TOOLS)
        self.count = 0

    @property
    def project(self) -> Project:
        return self.document.project

    def one_of(self, things: object) -> object:
        among = list(things)  # type: ignore[call-overload]
        return among[int(self.random.integers(len(among)))]

    def act(self) -> str:
        """Do something; return what."""
        self.count += 1
        name = str(self.one_of(ACTS))
        ACTS[name](self)
        return name

    def pose(self) -> None:
        field = self.one_of([field for unit in self.project.units for field in unit.fields])
        self.document.set_weights({str(field): round(self.random.uniform(0, 1), 3)}, gesture=f"{self.count // 3}")

    def drag_slider(self) -> None:
        unit = self.one_of(self.project.units)
        for weight in self.random.uniform(0, 2, 4):
            self.document.preview({str(unit.number): float(weight)})  # type: ignore[attr-defined]
        self.document.commit()

    def show_emotion(self) -> None:
        self.document.apply_emotion(self.one_of(self.project.emotions).name)  # type: ignore[attr-defined]

    def save_emotion(self) -> None:
        weights = {field: self.random.uniform(0.1, 1) for field in self.project.units[0].fields}
        made = emotions.with_expression(self.project, f"face {self.count}", weights)
        self.document.edit(made, "Save expression")

    def change_emotions(self) -> None:
        name = self.one_of(self.project.emotions).name  # type: ignore[attr-defined]
        if len(self.project.emotions) > 4:
            self.document.edit(emotions.without(self.project, [name]), "Delete expression")
        else:
            self.document.edit(emotions.moved(self.project, name, int(self.random.integers(4))), "Order")

    def stroke(self) -> None:
        self.wield("brush")
        for _ in range(int(self.random.integers(1, 4))):
            self.box.move(self.somewhere())
        if self.random.random() < 0.2:
            self.box.cancel()
        self.box.release(self.somewhere())

    def fill(self) -> None:
        self.wield("fill")

    def wield(self, tool: str) -> None:
        layer = LAYER[str(self.one_of(LAYER))]
        brush = self.box.bench.brush
        brush.change(layer=layer.key, radius=self.random.uniform(5, 40), strength=self.random.uniform(0, 1))
        brush.change(mirror=bool(self.random.random() < 0.5))
        mode = self.one_of([mode for mode in MODES[layer.kind] if mode != "comb" or tool == "brush"])
        brush.set_mode(mode)  # type: ignore[arg-type]
        brush.set_value(float(self.random.uniform(layer.low, layer.high)) if mode != "scale" else 1.1)
        self.box.take(tool)
        self.box.press(self.somewhere())

    def somewhere(self) -> Pointer:
        face = self.project.face
        triangle = int(self.random.integers(len(face.skin.triangles)))
        return Pointer(0, 0, skin=skin_hit(face, triangle, self.random.dirichlet(np.ones(3))))

    def change_muscle(self) -> None:
        muscle = self.one_of(self.project.muscles)
        wider = changed(muscle, "width", self.random.uniform(5, 30))  # type: ignore[arg-type]
        muscles = tuple(wider if each is muscle else each for each in self.project.muscles)
        self.document.edit(replace(self.project, muscles=muscles), "Width", gesture=f"width {self.count // 4}")

    def lay_muscle(self) -> None:
        muscle = self.one_of(self.project.muscles)
        place = self.random.uniform(-20, 20, 3)
        ways: list[Callable[[], Muscle]] = [
            lambda: bent(muscle, 0, place)[0],
            lambda: with_end(muscle, 0, "origin", place),
            lambda: added_fibre(muscle, Fibre(place, place + 9.0)),
            lambda: reordered(muscle, 0, 1),
            lambda: with_model(muscle, self.one_of(comparable_models(muscle))),
            lambda: coloured(muscle, "#5c999e"),
        ]
        made = ways[int(self.random.integers(len(ways)))]()
        muscles = put(self.project.muscles, made, self.project.face)
        self.document.edit(replace(self.project, muscles=muscles), "Lay")

    def copy_muscle(self) -> None:
        key = self.one_of(self.project.muscles).key  # type: ignore[attr-defined]
        made, _ = collection.duplicated(self.project, [key])
        self.document.edit(made, "Duplicate")

    def delete_or_rename_muscle(self) -> None:
        muscle = self.one_of(self.project.muscles)
        if len(self.project.muscles) > 4:
            self.document.edit(collection.deleted(self.project, [muscle.key]).project, "Delete")  # type: ignore[attr-defined]
        else:
            self.document.edit(collection.renamed(self.project, muscle.name, f"m{self.count}"), "Rename")  # type: ignore[attr-defined]

    def new_unit(self) -> None:
        made, number = units.with_new_unit(self.project)
        muscle = self.one_of(self.project.muscles).name  # type: ignore[attr-defined]
        self.document.edit(units.with_activation(made, number, muscle, 0.5), "New unit")

    def change_units(self) -> None:
        number = self.one_of(self.project.units).number  # type: ignore[attr-defined]
        unit = units.unit_of(self.project, number)
        ways: list[Callable[[], Project]] = [
            lambda: (parting.joined if unit.paired else parting.split)(self.project, number),
            lambda: units.renamed(self.project, number, f"unit {self.count}"),
            lambda: units.renumbered(self.project, number, 200 + self.count),
            lambda: units.with_jaw(self.project, number, 5.0, 1.0, float(self.random.uniform(-5, 5))),
            lambda: motions.with_eyes(self.project, number, turn=float(self.random.uniform(-30, 30)), lift=4.0),
            lambda: motions.with_head(self.project, number, tilt=float(self.random.uniform(-30, 30)), forward=9.0),
            lambda: units.moved_unit(self.project, number, int(self.random.integers(4))),
        ]
        if len(self.project.units) > 6:
            ways = [
                lambda: units.without_units(self.project, [number]),
                lambda: merged(self.project, number, self.project.units[0].number),
            ]
        self.document.edit(self.one_of(ways)(), "Change units")  # type: ignore[operator]

    def animate(self) -> None:
        time, project = round(float(self.random.uniform(0, 5)), 2), self.project
        weights = {str(self.one_of(project.units[0].fields)): float(self.random.uniform())}
        clip, units = project.animation, project.units
        ways: list[Callable[[], Animation]] = [
            lambda: expressions.with_expression(clip, time, weights, f"face {self.count}", units),
            lambda: placed(clip, self.one_of(library()), time, units)[0],  # type: ignore[arg-type]
            lambda: bulk.moved_keys(clip, selected(clip, 0, time), 0.1, 0.1, units)[0],
            lambda: bulk.deleted_keys(clip, selected(clip, time, time + 1)),
            lambda: dense.each_track(clip, [t.channel for t in clip.tracks], lambda t: dense.offset(t, 0.25)),
            lambda: marks.with_marker(clip, time, "here"),
        ]
        animation = self.one_of(ways)()  # type: ignore[operator]
        self.document.edit(replace(project, animation=animation), "Animate", gesture=f"clip {self.count // 3}")

    def sculpt(self) -> None:
        unit = self.one_of(self.project.units)
        rough = self.random.uniform(-2, 2, self.project.face.skin.positions.shape)
        rough[self.random.random(len(rough)) < 0.8] = 0.0
        field = str(self.one_of(unit.fields))  # type: ignore[attr-defined]
        layers = {**sculpting.layers_of(self.project, unit), field: correction_of(rough)}  # type: ignore[arg-type]
        made = sculpting.with_corrections(self.project, unit, layers)  # type: ignore[arg-type]
        gesture = f"sculpt {self.count // 3}"
        self.document.run(set_corrections(self.project.corrections, made.corrections, "Sculpt", gesture))

    def change_sculpt(self) -> None:
        sculpted = sculpting.sculpted_units(self.project) or {self.project.units[0].number}
        number, partners = int(self.one_of(sorted(sculpted))), self.project.face.mirror  # type: ignore[call-overload]
        other = int(self.one_of(self.project.units).number)  # type: ignore[attr-defined]
        ways: list[Callable[[], Project]] = [
            lambda: sculpting.with_amount(self.project, number, self.random.uniform()),
            lambda: sculpting.with_switch(self.project, number, bool(self.random.random() < 0.5)),
            lambda: sculpting.symmetric(self.project, number, "L", partners),
            lambda: sculpting.copied_to(self.project, number, other),
            lambda: sculpting.cleared(self.project, number),
            lambda: mirrored_unit(self.project, number, partners),
        ]
        self.document.edit(self.one_of(ways)(), "Change sculpt")  # type: ignore[operator]

    def lay_on_pad(self) -> None:
        name = self.one_of(self.project.emotions).name  # type: ignore[attr-defined]
        place = None if self.random.random() < 0.2 else (self.random.uniform(), self.random.uniform())
        self.document.edit(pad.with_place(self.project, name, place), "Place")

    def paste_emotions(self) -> None:
        text = expressions_text(self.project.emotions[:1], self.project.units)
        made, _ = with_pasted(self.project, expressions_of(text, self.project.units))
        self.document.edit(made, "Paste")

    def move_skull(self) -> None:
        shift, turn = self.random.uniform(-4, 4, (2, 3)).round(2).tolist()
        pose = Pose(tuple(shift), tuple(turn), (1.0, round(self.random.uniform(0.9, 1.1), 3), 1.0))
        self.document.edit(with_pose(self.project, pose, bool(self.random.integers(2))), "Move skull")

    def choose_jaw(self) -> None:
        if self.random.integers(2):
            region = self.random.random(len(whole_skull(self.project.face.skull).mesh.positions)) < 0.7
            self.document.edit(with_jaw_region(self.project, region), "Choose the jaw")
        else:
            ends = np.array([[-40.0, 20, -40], [40, 20, -40]]) + self.random.uniform(-5, 5, (2, 3))
            self.document.edit(with_jaw_axis(self.project, *ends), "Place the jaw’s axis")

    def other_settings(self) -> None:
        density = int(self.random.integers(2, 5))
        other = replace(self.project, settings=replace(self.project.settings, density=density))
        self.document.run(ReplaceProject("Density", self.project, other))

    def script(self) -> None:
        number = self.project.units[0].number
        text = f"u = au({number})\nu.weight = {self.random.uniform():.2f}\npaint('stiffness', 0.02, at=3)\nu.note = 'x'"
        assert run_script(text, self.document).error == ""

    def back_and_forth(self) -> None:
        self.document.undo()
        self.document.redo()


HELPERS = {"act", "one_of", "wield", "somewhere", "project"}
ACTS: dict[str, Callable[[Hands], None]] = {
    name: act for name, act in vars(Hands).items() if not name.startswith("__") and name not in HELPERS
}
"""All that a person here can do."""


def fingerprint(project: Project) -> tuple[str, str]:
    """Return what only a project has that is the same to the last bit, in the same order."""
    layers = [
        (name, each.vertices.tobytes(), each.moved.tobytes(), each.amount, each.on)
        for name, each in project.corrections.items()
    ]
    arrays = {name: array.tobytes() for name, array in animation_arrays(project.animation).items()}
    named = (project.emotions, project.expression, project.units, layers, animation_json(project.animation), arrays)
    return solution_key(project), repr(named)


@pytest.fixture(scope="module")
def walked(project: Project) -> tuple[Document, list[tuple[str, str]]]:
    """Walk once; give the document and the fingerprint of its state after every step, the first one before."""
    document = Document(project)
    hands = Hands(document, SEED)
    states = [fingerprint(document.project)]
    done: set[str] = set()
    while len(done) < len(ACTS) or len(states) <= COMMANDS:
        try:
            done.add(hands.act())
        except (UnitError, NumberError, SkullError):
            continue
        states[len(document.history.done) :] = [fingerprint(document.project)]
    return document, states


def test_all_of_it_is_undone_to_the_bit_and_done_again(
    walked: tuple[Document, list[tuple[str, str]]], project: Project
) -> None:
    document, states = walked
    last = project_bytes(document.project)
    assert len(document.history.done) == len(states) - 1 >= COMMANDS
    for expected in reversed(states[:-1]):
        document.undo()
        assert fingerprint(document.project) == expected
    assert document.history.to_undo is None
    assert not document.dirty
    assert project_bytes(document.project) == project_bytes(project)
    for expected in states[1:]:
        document.redo()
        assert fingerprint(document.project) == expected
    assert document.history.to_redo is None
    assert project_bytes(document.project) == last


def test_what_comes_of_it_can_be_saved_and_opened(walked: tuple[Document, list[tuple[str, str]]]) -> None:
    document, _ = walked
    data = project_bytes(document.project)
    assert project_bytes(project_of(data)) == data


def test_all_of_it_costs_little_to_remember(walked: tuple[Document, list[tuple[str, str]]]) -> None:
    document, states = walked
    whole = sum(getattr(document.project.face.layers, name).nbytes for name in vars(document.project.face.layers))
    assert document.history.cost < len(states) * whole
