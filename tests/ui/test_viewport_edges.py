"""What is thin or cut off looks calm: lashes in motion as at rest, the section of the neck on every backdrop."""

import numpy as np
import pytest

from tests.ui.sitter import SIZE, sitter
from ui.headless.stage import Stage, stage
from ui.viewport.neck import CAP
from ui.viewport.surface import ByteArray

DOTS = 0.05
"""Share of full light by which one sample per pixel may be darker than sixteen, on all but a few pixels."""


def upper_lid(stage: Stage, picture: ByteArray) -> np.ndarray:
    """Grey pixels about the upper lashes of the subject's left eye, 0..1."""
    renderer = stage.scene.renderer
    eye = next(each for each in sitter()[0].face.eyes if each.side == "L")
    renderer.SetWorldPoint(*eye.centre, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    scale = renderer.GetSize()[1] / SIZE[1]
    row, column = round(SIZE[1] - y / scale), round(x / scale)
    return picture[row - 14 : row - 2, column - 16 : column + 16].mean(axis=2) / 255.0


def test_lashes_are_no_dots_where_a_pixel_has_one_sample() -> None:
    seen = []
    for finer in (1, 4):
        with stage(SIZE, samples=0, finer=finer) as made:
            made.scene.show(*sitter())
            seen.append(upper_lid(made, made.picture()))
    rough, fine = seen
    assert np.ptp(fine) > 0.3
    assert np.percentile(np.abs(rough - fine), 95) < DOTS


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_section_of_the_neck_is_one_calm_colour_on_every_backdrop(theme: str) -> None:
    with stage(SIZE, theme, samples=0, finer=1) as made:
        made.scene.show(*sitter())
        made.scene.renderer.GetActiveCamera().Elevation(-60)
        made.scene.renderer.ResetCameraClippingRange()
        picture = made.picture()
    section = np.all(np.abs(picture / 255.0 - CAP) < 0.01, axis=2)
    assert section.sum() > 0.03 * section.size
