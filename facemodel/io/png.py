"""PNG pictures as arrays, looked at before they are unpacked."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, PngImagePlugin

from facemodel.errors import ProjectError
from facemodel.io.disk import read_file, replacing

SMALLEST, LARGEST = 16, 8192
"""Texels along a side: fewer show nothing of a face, more are beyond what is painted and fill the memory."""

LARGEST_FILE = 1 << 28
"""Bytes; a picture of the largest size that does not compress at all."""

SIGNATURE = b"\x89PNG\r\n\x1a\n"
HEADER = struct.Struct(">8sI4sIIBB")
COLOURS: Mapping[int, str] = {0: "grey", 2: "RGB", 3: "palette", 4: "grey with alpha", 6: "RGBA"}


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture.

    Attributes
    ----------
    texels : (H, W, C) uint8 or uint16
    colour : ``grey``, ``RGB`` or ``RGBA``
    notes : texts that are kept with it, by name
    """

    texels: NDArray[Any]
    colour: str
    notes: Mapping[str, str]

    @property
    def white(self) -> int:
        """The number that stands for white."""
        return int(np.iinfo(self.texels.dtype).max)


def write_png(path: Path, texels: NDArray[Any], notes: Mapping[str, str]) -> None:
    """Write texels (H, W, C), C = 1, 3 or 4, with some texts.

    Raises
    ------
    ProjectError
        If the file cannot be written; a previous one stays as it was.
    """
    info = PngImagePlugin.PngInfo()
    for name, text in notes.items():
        info.add_text(name, text)
    image = Image.fromarray(texels[..., 0] if texels.shape[2] == 1 else texels)
    with replacing(path) as stream:
        image.save(stream, format="PNG", pnginfo=info)


def read_png(path: Path, colours: tuple[str, ...], depths: tuple[int, ...], wanted: str) -> Picture:
    """Read a picture that is of one of some colour types and depths.

    Parameters
    ----------
    path : the file
    colours : of `COLOURS`
    depths : bits per channel
    wanted : what it is read for, for the sentence, for example ``the layer “Grain”``

    Raises
    ------
    ProjectError
        If there is no such file, it is no PNG picture, damaged, of another size or of another colour type.
    """
    data = read_file(path, LARGEST_FILE)
    colour = _checked_header(path, data, colours, depths, wanted)
    try:
        with Image.open(BytesIO(data), formats=["PNG"]) as image:
            image.load()
            texels = np.asarray(image)
            notes = {str(name): str(text) for name, text in image.info.items() if isinstance(text, str)}
    except (OSError, SyntaxError, ValueError, zlib.error, struct.error) as error:
        raise ProjectError(f"“{path}” cannot be opened: the picture is damaged; export it again.") from error
    return Picture(texels[..., None] if texels.ndim == 2 else texels, colour, notes)


def _checked_header(path: Path, data: bytes, colours: tuple[str, ...], depths: tuple[int, ...], wanted: str) -> str:
    refused = f"“{path}” cannot be used for {wanted}:"
    if len(data) < HEADER.size or not data.startswith(SIGNATURE):
        raise ProjectError(f"{refused} it is not a PNG picture; export it as one.")
    _, _, _, width, height, depth, kind = HEADER.unpack_from(data)
    if not all(SMALLEST <= side <= LARGEST for side in (width, height)):
        raise ProjectError(
            f"{refused} it has {width} x {height} texels; resize it to between {SMALLEST} and {LARGEST} along each "
            "side."
        )
    colour = COLOURS.get(kind, "unknown")
    if colour not in colours or depth not in depths:
        bits = " or ".join(map(str, depths))
        raise ProjectError(
            f"{refused} it is {colour} with {depth} bits, and {' or '.join(colours)} with {bits} bits per channel is "
            "needed; convert it in your painting program."
        )
    return colour
