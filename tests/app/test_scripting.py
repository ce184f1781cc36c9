"""A script does what the mouse does, in one step; one that raises says where and leaves nothing behind."""

from ast import literal_eval

import numpy as np
import pytest

from app.authoring.bare import bare_project
from app.document import Document
from app.scripting import Console, run_script
from app.view import View
from facemodel.laying.collection import muscle_of
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import solve_project
from fem import Support

WORK = """
au(12).weight = 0.5
smirk = new_au("smirk")
smirk.contract("zygomaticus_major", 0.8)
paint("stiffness", 0.01, at=(0, 0, 20), radius=15)
muscle("zygomaticus_major_L").width = 14
save_expression("half a smile")
"""


def test_a_script_is_one_step_that_can_be_undone_and_done_again(document: Document, project: Project) -> None:
    outcome = run_script(WORK, document, "Set up")
    assert (outcome.error, outcome.complete) == ("", True)
    assert document.history.done == ("Set up",)
    made = document.project
    assert made.expression == {"12L": 0.5, "12R": 0.5}
    assert made.units[-1].muscles == {"zygomaticus_major": 0.8}
    assert (made.face.layers.stiffness == 0.01).any()
    assert {muscle.width for muscle in made.muscles} == {14}
    assert made.emotions[-1].name == "half a smile"
    document.undo()
    assert document.project.face.layers.stiffness.tobytes() == project.face.layers.stiffness.tobytes()
    assert (document.project.muscles, document.project.units) == (project.muscles, project.units)
    document.redo()
    assert document.project.units == made.units


@pytest.mark.parametrize(
    ("last", "line", "why"),
    [
        ("1 / 0", 8, "ZeroDivisionError: division by zero."),
        ("unheard_of()", 8, "NameError: name 'unheard_of' is not defined."),
        ("au(99)", 8, "There is no action unit “99”"),
        ("au(12).weight = 7", 8, "The weight 7 of action unit 12"),
        ("muscle('risorius_L')", 8, "There is no muscle “risorius_L”"),
        ("paint('colour', 1)", 8, "There is no layer “colour”"),
        ("def f():\n    raise ValueError('deep')\nf()", 9, "ValueError: deep."),
        ("raise SystemExit", None, "asked to end"),
        ("if True", 8, "no Python"),
        ("'\x00'", None, "no Python"),
    ],
)
def test_a_script_that_raises_says_where_and_leaves_nothing(
    document: Document, project: Project, last: str, line: int | None, why: str
) -> None:
    document.set_weights({"17": 0.25})
    before = document.project
    outcome = run_script(f"{WORK}{last}\n", document)
    assert why in outcome.error
    assert outcome.error.endswith(".")
    assert line is None or f"ine {line}" in outcome.error
    assert document.project is before
    assert document.history.done == ("Chin raiser",)


def test_what_a_script_prints_is_told_even_if_it_raises(document: Document) -> None:
    outcome = run_script("print('so far')\nraise OSError", document)
    assert outcome.output == "so far\n"
    assert "line 2: OSError" in outcome.error
    assert "raise OSError" in outcome.details or outcome.details.count("line 2") == 1


def test_the_console_keeps_its_names_and_shows_values(document: Document) -> None:
    console = Console(document)
    assert console.enter("w = 0.25").output == ""
    assert console.enter("w * 2").output == "0.5\n"
    console.enter("au(17).weight = w")
    assert document.project.expression == {"17": 0.25}
    assert console.enter("au('chin raiser')").output == "au(17): chin raiser, 17\n"
    assert console.enter("expression()").output == "'17=0.25'\n"
    assert {"w", "au", "np", "paint"} <= set(console.names)


def test_the_console_waits_for_the_rest_of_a_block(document: Document) -> None:
    console = Console(document)
    assert not console.enter("for n in (12, 20):").complete
    block = "for n in (12, 20):\n    au(n).weight = 0.5\n"
    assert console.enter(block).complete
    assert document.project.expression == dict.fromkeys(("12L", "12R", "20L", "20R"), 0.5)
    assert len(document.history.done) == 1


def test_the_console_sees_what_the_mouse_did_meanwhile(document: Document) -> None:
    console = Console(document)
    console.enter("unit = au(17)")
    document.set_weights({"17": 0.75})
    assert console.enter("unit.weight").output == "0.75\n"
    document.preview({"17": 0.5})
    assert console.enter("unit.weight").output == "0.5\n"
    assert not document.held


def test_looking_is_no_step(document: Document, project: Project) -> None:
    run_script("units(); muscles(); values('stiffness'); face(); layers(); copy_muscles()", document)
    assert document.project is project
    assert document.history.done == ()


def test_a_script_may_take_back_its_own_steps_and_no_others(document: Document) -> None:
    document.set_weights({"26": 0.5})
    run_script("au(17).weight = 1\nundo()\nundo()\nundo()\nau(12).weight = 1\nundo()\nredo()", document)
    assert document.project.expression == {"26": 0.5, "12L": 1.0, "12R": 1.0}
    assert len(document.history.done) == 2


def test_units_are_made_and_changed(document: Document) -> None:
    outcome = run_script(
        "twin = au(12).duplicate()\ntwin.name = 'twin'\ntwin.number = 13\ntwin.note = 'a copy'\n"
        "twin.limit = 1.5\ntwin.move_jaw(5, 1)\ntwin.move(0)\n"
        "au(17).split()\nau(20).join()\nau(12).merge(13)\nau(26).delete()\n"
        "print(au(12).jaw, au(12).fields, sorted(au(12).muscles))",
        document,
    )
    assert outcome.error == ""
    assert outcome.output == "JawMotion(degrees=5.0, slide=1.0, side=0.0) ('12L', '12R') ['zygomaticus_major']\n"
    assert [unit.number for unit in document.project.units] == [12, 20, 17]
    assert [unit.paired for unit in document.project.units] == [True, False, True]


def test_expressions_are_blended_and_told_in_letters(document: Document) -> None:
    pad = "{'happiness': (0, 0), 'surprise': (1, 0)}"
    outcome = run_script(
        f"blend({pad}, (0.5, 0.7))\nprint(au(12).letter, au(26).letter, au(17).letter + '-')", document
    )
    assert outcome.error == ""
    assert outcome.output == "B B -\n"
    assert document.shown == pytest.approx({"12L": 0.45, "12R": 0.45, "20L": 0.05, "26": 0.4})
    assert "boredom" in run_script("blend({'boredom': (0, 0)}, (0, 0))", document).error


def test_the_axis_of_the_jaw_is_placed(document: Document) -> None:
    told: list[str] = []
    document.skull_changed.connect(lambda: told.append("skull"))
    assert run_script("jaw_axis((-45, 18, -38), (45, 20, -38))", document).error == ""
    assert document.project.face.skull.jaw.axis.tolist() == [[-45, 18, -38], [45, 20, -38]]
    assert told == ["skull"]
    assert "apart" in run_script("jaw_axis((45, 18, -38), (-45, 20, -38))", document).error
    assert "numbers" in run_script("jaw_axis((0, 0), (45, 20, -38))", document).error


def test_a_whole_layer_is_read_and_set(document: Document, project: Project) -> None:
    assert run_script("set_values('stiffness', values('stiffness') * 2)", document).error == ""
    assert np.array_equal(document.project.face.layers.stiffness, project.face.layers.stiffness * 2)
    assert "one for each vertex" in run_script("set_values('stiffness', [1, 2])", document).error
    assert run_script("paint('supports', 'sliding')", document).error == ""
    assert set(document.project.face.layers.supports) == {Support.SLIDING}
    assert "free" in run_script("paint('supports', 'glued')", document).error


def test_fields_are_read_once_the_face_is_solved(document: Document, project: Project) -> None:
    assert "not solved" in run_script("field('12L')", document).error
    document.accept(solve_project(project), project)
    peak = np.linalg.norm(solve_project(project).basis.field("12L"), axis=1).max()
    assert float(run_script("print(np.linalg.norm(field('12L'), axis=1).max())", document).output) == pytest.approx(
        peak
    )


def test_muscles_are_laid_moved_and_copied_by_script() -> None:
    document = Document(new_project())
    outcome = run_script(
        """
m = new_muscle("Malaris", "zygion_L", "mouth_corner_L")
m.set("strength", 0.02)
m.kappa, m.title = 4, "Malaris major"
m.move("attachment", place("cheek_L"))
m.bend(place("zygion_L") * 0.5 + place("cheek_L") * 0.5)
m.mirror()
m.rename("malaris_major")
copied = copy_muscles(m.key)
m.duplicate().delete()
(pasted,) = paste_muscles(copied)
print(m.key, pasted.key, m.kappa, m.strength)
pasted.delete()
""",
        document,
    )
    assert outcome.error == ""
    assert outcome.output == "malaris_major_L malaris_major_2_L 4.0 0.02\n"
    keys = [muscle.key for muscle in document.project.muscles[-2:]]
    assert keys == ["malaris_major_L", "malaris_major_R"]
    assert run_script("muscle('malaris_major_L').colour = '#F2845C'", document).error == ""
    assert muscle_of(document.project, "malaris_major_L").colour == "#f2845c"
    assert "no parameter" in run_script("muscle('malaris_major_L').softness", document).error
    assert "model" in run_script("muscle('malaris_major_L').model = 'rope'", document).error


def test_everything_of_a_muscle_that_the_mouse_drags_a_script_can_set() -> None:
    document = Document(new_project())
    outcome = run_script(
        """
m = muscle("zygomaticus_major_L")
count = len(m.value.fibres)
m.linked = False
m.add_fibre(place("zygion_L"), place("mouth_corner_L"))
m.order_fibre(0, count)
m.remove_fibre(0)
m.bend(place("zygion_L") * 0.5 + place("mouth_corner_L") * 0.5)
m.bend(m.value.fibres[0].via[0] + [0, 0, 2], at=0)
m.straighten()
m.move("origin", m.value.fibres[0].origin + [1, 2, 0], snap=False)
m.model = "cosine"
m.drag("share", (m.value.fibres[0].origin + m.value.fibres[0].attachment) / 2)
other = muscle("zygomaticus_major_R")
print(len(m.value.fibres) == count, round(m.get("cosine.share"), 3), sorted(m.models), other.linked)
m.reset("cosine.share")
print(m.get("cosine.share"))
""",
        document,
    )
    assert outcome.error == ""
    assert outcome.output == "True 0.5 ['cosine', 'fibre', 'quadrilateral'] False\n0.3\n"
    assert muscle_of(document.project, "zygomaticus_major_R").model == "fibre"


def test_rings_and_the_force_of_the_jaw_are_laid_by_script() -> None:
    document = Document(new_project())
    outcome = run_script(
        """
ring = new_ring("Kiss", "mid_philtrum", "mouth_corner_L", 9)
ring.model = "mouth"
ring.draw("sigma", [(0, 0), (1, 0.8), (2, 0)])
ring.stretch("short", 12)
ring.centre(ring.value.ring.centre + [0, 0, 1])
ring.half("up")
jaw = new_jaw_force()
jaw.drag("force", jaw.handles()[0][3])
print(ring.key, ring.value.ring.sector[1] > 0.5, ring.get("profiles.sigma").values, round(jaw.strength, 4))
""",
        document,
    )
    assert outcome.error == ""
    assert outcome.output == "kiss True (0.0, 0.8, 0.0) 0.01\n"
    assert "no handle" in run_script("muscle('kiss').drag('origin', [0, 0, 0])", document).error
    assert "is no place" in run_script("muscle('kiss').centre([0, 0])", document).error
    assert "choose one of whole" in run_script("muscle('kiss').half('third')", document).error


def test_muscles_of_another_head_are_fitted_by_script() -> None:
    document = Document(bare_project("ben"))
    count = len(new_project("ada").muscles)
    outcome = run_script("print(fit_muscles('ada')[0], len(muscles()))", document)
    assert outcome.error == ""
    assert outcome.output == f"{count} muscles by 65 landmarks. {count}\n"
    assert document.history.done[-1:] != ()
    document.undo()
    assert document.project.muscles == ()


def test_models_are_compared_by_script(document: Document) -> None:
    outcome = run_script("print(sorted(compare_models('zygomaticus_major_L').items()))", document)
    assert outcome.error == ""
    found = dict(literal_eval(outcome.output))
    assert set(found) == {"fibre", "quadrilateral", "cosine"}
    assert found["fibre"][1] == pytest.approx(1.0)
    assert all(largest > 0 for largest, _ in found.values())


def test_a_script_switches_the_pure_linear_sum_of_a_view(document: Document) -> None:
    view = View()
    assert run_script("linear_sum()", document, view=view).error == ""
    assert view.state.linear
    assert run_script("linear_sum(False)\nraise OSError", document, view=view).error
    assert view.state.linear
    assert "no window" in run_script("linear_sum()", document).error
    assert document.history.done == ()
