"""What README tells a newcomer to type is there."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def readme(repository: Path) -> str:
    return (repository / "README.md").read_text("utf-8")


@pytest.fixture(scope="module")
def commands(readme: str) -> list[str]:
    """Return the command lines of README's shell blocks, without comments."""
    blocks = re.findall(r"```sh\n(.*?)```", readme, re.DOTALL)
    lines = [line.split(" #")[0].strip() for block in blocks for line in block.splitlines()]
    return [line for line in lines if line]


HELP = """
import contextlib, io, json, sys
from ui.launch import main

texts = {}
for command in sys.argv[1:]:
    with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.suppress(SystemExit):
        main([command, "--help"])
    texts[command] = said.getvalue()
print(json.dumps(texts))
"""


def help_of(repository: Path, *commands: str) -> dict[str, str]:
    """Return what each command says when it is asked for help."""
    done = subprocess.run(
        [sys.executable, "-c", HELP, *commands], cwd=repository, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_make_targets_exist(readme: str, commands: list[str], repository: Path) -> None:
    targets = set(re.findall(r"^([a-z]+):", (repository / "Makefile").read_text("utf-8"), re.MULTILINE))
    asked = {line.split()[1] for line in commands if line.startswith("make ")}
    assert {"run", "test"} <= asked
    assert asked | set(re.findall(r"`make ([a-z]+)`", readme)) <= targets


def test_commands_and_their_options_exist(commands: list[str], repository: Path) -> None:
    asked: dict[str, set[str]] = {}
    for line in commands:
        if match := re.match(r"risorius ([a-z]+)", line):
            asked.setdefault(match[1], set()).update(re.findall(r"--[a-z-]+", line))
    assert {"new", "solve", "info", "render", "export", "gallery"} <= set(asked)
    for command, text in help_of(repository, *asked).items():
        assert f"risorius {command}" in text
        assert asked[command] <= set(re.findall(r"--[a-z-]+", text)), command


def test_files_it_points_to_exist(readme: str, repository: Path) -> None:
    links = re.findall(r"\]\(([^):#]+)\)", readme)
    assert links
    assert [link for link in links if not (repository / link).exists()] == []
