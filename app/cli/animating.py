"""What the commands about animation do."""

from __future__ import annotations

import sys
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from app.authoring.importing import with_capture, with_sound, with_spoken
from app.cli.progress import ProgressLine
from app.speech import espeak_program, spoken_sound
from facemodel.animation.demo import SPOKEN_AT, TEXT, demo_animation
from facemodel.animation.evaluation import sampled
from facemodel.animation.sound import voiced_span
from facemodel.cache import solve_cached
from facemodel.errors import ProjectError
from facemodel.faces import DEFAULT_FACE
from facemodel.io.audio import write_sound
from facemodel.io.disk import checked_target
from facemodel.io.project_file import load_project, save_project
from facemodel.io.speech import read_speech
from facemodel.io.weights import read_capture
from facemodel.io.weights.mapping_file import load_mapping
from facemodel.io.weights.writing import WEIGHT_EXPORTS, Animated, export_weights
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.sculpting.corrected import Corrector

PROJECT_SUFFIX = ".risorius"


def animate(asked: Namespace) -> int:
    """Bring captures and speech into a project, and write what comes of it."""
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
    print(f"Wrote {asked.out}: {_write(project, asked.out, asked.format, asked.fps)}")
    return 0


def demo(asked: Namespace) -> int:
    """Write the piece that shows what a face can do."""
    checked_target(asked.out)
    project = new_project(asked.face or DEFAULT_FACE)
    voice = asked.out.with_suffix(".wav")
    if asked.out.suffix.lower() == PROJECT_SUFFIX and espeak_program() is not None:
        played = _voiced(project, voice)
        print(f"Wrote {voice}: a voice by eSpeak NG")
    else:
        played = replace(project, animation=demo_animation(project.units))
    print(f"Wrote {asked.out}: {_write(played, asked.out, asked.format, asked.fps)}")
    return 0


def _voiced(project: Project, voice: Path) -> Project:
    """The piece with a voice that says the line, written beside it."""
    checked_target(voice)
    sound = spoken_sound(TEXT)
    write_sound(sound, voice)
    played = replace(project, animation=demo_animation(project.units, voiced_span(sound)))
    return with_sound(played, voice, sound, voice.parent, SPOKEN_AT)


def _write(project: Project, out: Path, kind: str | None, rate: float | None) -> str:
    """Write a project or its weights over time, by the file's suffix; what was written, in words."""
    if out.suffix.lower() == PROJECT_SUFFIX:
        save_project(project, out)
        return f"{len(project.animation.tracks)} tracks, {project.animation.duration:g} seconds"
    chosen = kind or next((name for name, each in WEIGHT_EXPORTS.items() if each.suffix == out.suffix.lower()), None)
    if chosen is None:
        suffixes = ", ".join(sorted({each.suffix for each in WEIGHT_EXPORTS.values()} | {PROJECT_SUFFIX}))
        raise ProjectError(f"“{out}” cannot be written: animations are in {suffixes} files.")
    clip = sampled(project.animation, project.units, rate)
    if not clip.channels:
        raise ProjectError(
            f"“{out}” would be empty, since nothing in the project moves; bring in a capture with --capture."
        )
    basis = None
    if WEIGHT_EXPORTS[chosen].needs_basis:
        line = ProgressLine(sys.stderr)
        try:
            basis = Corrector()(solve_cached(project, line), project).basis
        finally:
            line.clear()
    export_weights(Animated(clip, project.units, project.face, basis, out.stem), out, chosen)
    return f"{len(clip.times)} frames at {clip.rate:g} a second, {WEIGHT_EXPORTS[chosen].holds}"
