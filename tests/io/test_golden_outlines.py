"""Exported files look as they always did."""

import pytest

from tests.io.golden_outlines import FOLDER, OUTLINES, numbers_and_rest


@pytest.mark.parametrize("name", OUTLINES)
def test_a_format_is_what_it_was(name: str) -> None:
    kept, kept_rest = numbers_and_rest((FOLDER / name).read_text("utf-8").rstrip("\n"))
    now, now_rest = numbers_and_rest(OUTLINES[name]().rstrip("\n"))
    assert now_rest == kept_rest
    assert now == pytest.approx(kept, abs=2e-5, rel=1e-4)


def test_every_format_of_models_has_an_outline() -> None:
    kept = {path.name.split(".")[1] for path in FOLDER.iterdir()}
    assert kept == {"glb", "usda", "obj", "ply"}
