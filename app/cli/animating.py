"""What the commands about animation do."""

from __future__ import annotations

import sys
from argparse import Namespace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from app.authoring.importing import with_capture, with_spoken
from app.authoring.recordings import capture_from
from app.cli.commands import solved
from app.cli.ordering import export_animation
from app.cli.screen import Screen
from app.examples import demo_project, examples_folder
from facemodel.basis import Basis
from facemodel.faces import DEFAULT_FACE
from facemodel.io.disk import checked_target
from facemodel.io.project_file import load_project, save_project
from facemodel.io.speech import read_speech
from facemodel.io.weights.mapping_file import load_mapping
from facemodel.project import Project

PROJECT_SUFFIX = ".risorius"


def animate(asked: Namespace, screen: Screen) -> int:
    """Bring captures and speech into a project, and write or export what comes of it, by the suffix."""
    checked_target(asked.out)
    project = load_project(asked.project)
    notes: list[str] = []
    for path in asked.capture:
        capture = capture_from(path, project, partial(_basis, project, asked), asked.rate, asked.neutral)
        table = load_mapping(asked.table) if asked.table else None
        imported = with_capture(project, capture, table)
        project, notes = imported.project, [*notes, *imported.notes]
    for path in asked.speech:
        spoken = read_speech(path, asked.rate)
        imported = with_spoken(project, spoken.phonemes, spoken.words)
        project, notes = imported.project, [*notes, *spoken.notes, *imported.notes]
    for note in notes:
        print(f"risorius: {note}", file=sys.stderr)
    folder = asked.project.absolute().parent
    print(f"Wrote {asked.out}: {_written(project, asked, screen, folder)}")
    return 0


def _basis(project: Project, asked: Namespace) -> Basis:
    return solved(project, asked.basis).basis


DEMO_FILM = Path("risorius-demo.mp4")
"""Where the piece goes if nobody says where and there is no display to show it on."""


def demo(asked: Namespace, screen: Screen) -> int:
    """Open the piece that shows what a face can do, or write it."""
    face = asked.face or DEFAULT_FACE
    if asked.out is None and screen.displays():
        return screen.edit(None, demo_project(examples_folder() / "demo-line.wav", face))
    if asked.out is None:
        print(f"There is no display here, so the demo is filmed into {DEMO_FILM}")
        asked.out = DEMO_FILM
    out: Path = asked.out
    checked_target(out)
    home = out.absolute().parent
    if out.suffix.lower() == PROJECT_SUFFIX:
        # A project keeps its voice beside it; what is played once does without.
        voice = checked_target(out.with_suffix(".wav"))
        print(f"Wrote {out}: {_written(demo_project(voice, face, home), asked, screen, home)}")
        return 0
    with TemporaryDirectory() as folder:
        project = demo_project(Path(folder) / "line.wav", face)
        print(f"Wrote {out}: {_written(project, asked, screen, home)}")
    return 0


def _written(project: Project, asked: Namespace, screen: Screen, folder: Path) -> str:
    """Write a project or export its animation, by the file's suffix; what was written, in words."""
    out: Path = asked.out
    if out.suffix.lower() == PROJECT_SUFFIX:
        save_project(project, out)
        return f"{len(project.animation.tracks)} tracks, {project.animation.duration:g} seconds"
    return export_animation(project, asked, screen, folder)
