"""What the commands about animation do."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path
from tempfile import TemporaryDirectory

from app.authoring.importing import with_capture, with_spoken
from app.cli.commands import solved
from app.cli.filming import asked_span, film
from app.cli.screen import Screen
from app.examples import demo_project, examples_folder
from facemodel.animation.evaluation import sampled
from facemodel.errors import ProjectError
from facemodel.faces import DEFAULT_FACE
from facemodel.io.disk import checked_target
from facemodel.io.film import FILMS
from facemodel.io.project_file import load_project, save_project
from facemodel.io.speech import read_speech
from facemodel.io.weights import read_capture
from facemodel.io.weights.mapping_file import load_mapping
from facemodel.io.weights.writing import WEIGHT_EXPORTS, Animated, export_weights
from facemodel.project import Project

PROJECT_SUFFIX = ".risorius"


def animate(asked: Namespace, screen: Screen) -> int:
    """Bring captures and speech into a project, and write what comes of it, as a film where the suffix is of one."""
    checked_target(asked.out)
    project = load_project(asked.project)
    notes: list[str] = []
    for path in asked.capture:
        capture = read_capture(path, project.units, asked.rate)
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
    """Write a project, its weights over time or a film of it, by the file's suffix; what was written, in words."""
    out: Path = asked.out
    if out.suffix.lower() in FILMS:
        return film(project, asked, screen, folder)
    if out.suffix.lower() == PROJECT_SUFFIX:
        save_project(project, out)
        return f"{len(project.animation.tracks)} tracks, {project.animation.duration:g} seconds"
    chosen = asked.format or next((n for n, each in WEIGHT_EXPORTS.items() if each.suffix == out.suffix.lower()), None)
    if chosen is None:
        suffixes = ", ".join([*FILMS, *sorted({each.suffix for each in WEIGHT_EXPORTS.values()} | {PROJECT_SUFFIX})])
        raise ProjectError(f"“{out}” cannot be written: animations are in {suffixes} files.")
    return _weights(project, asked, chosen)


def _weights(project: Project, asked: Namespace, chosen: str) -> str:
    """Write the weights over time in one of their formats."""
    out: Path = asked.out
    span = asked_span(asked.range, asked.fps or project.animation.rate)
    clip = sampled(project.animation, project.units, asked.fps, span)
    if not clip.channels:
        raise ProjectError(
            f"“{out}” would be empty, since nothing in the project moves; bring in a capture with --capture."
        )
    basis = solved(project, asked.basis).basis if WEIGHT_EXPORTS[chosen].needs_basis else None
    export_weights(Animated(clip, project.units, project.face, basis, out.stem), out, chosen)
    return f"{len(clip.times)} frames at {clip.rate:g} a second, {WEIGHT_EXPORTS[chosen].holds}"
