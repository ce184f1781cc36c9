"""What README tells a newcomer to type is there."""

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


def run_risorius(repository: Path, *arguments: str) -> str:
    code = "import sys; from ui.launch import main; sys.exit(main())"
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], cwd=repository, capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


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
    for command, options in asked.items():
        help_text = run_risorius(repository, command, "--help")
        assert options <= set(re.findall(r"--[a-z-]+", help_text)), command


def test_files_it_points_to_exist(readme: str, repository: Path) -> None:
    links = re.findall(r"\]\(([^):#]+)\)", readme)
    assert links
    assert [link for link in links if not (repository / link).exists()] == []
