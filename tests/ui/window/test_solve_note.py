"""One line tells whether the face is that of the paint."""

import pytest

from ui.panels.tissue.solve_note import told


@pytest.mark.parametrize(
    ("stale", "solving", "said"),
    [
        (1, False, "1 field is not solved for what is painted; F5 solves it."),
        (2, False, "2 fields are not solved for what is painted; F5 solves them."),
        (1, True, "Solving; until then 1 field is as before the last step."),
        (62, True, "Solving; until then 62 fields are as before the last step."),
    ],
)
def test_fields_are_counted_in_words(stale: int, solving: bool, said: str) -> None:
    assert told(stale, solving) == said
