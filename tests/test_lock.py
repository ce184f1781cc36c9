"""The lock file pins all that is asked for, and says nothing of where it was made."""

import re
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.version import Version

PIN = re.compile(r"^([a-z0-9-]+)==([\w.]+)", re.MULTILINE)
LINE = re.compile(r"\s*|[a-z0-9-]+==[\w.]+( ; [\w .'<>=!()]+)? \\|\s+--hash=sha256:[0-9a-f]{64}( \\)?")


@pytest.fixture(scope="module")
def lock(repository: Path) -> str:
    return (repository / "requirements.lock").read_text("utf-8")


def test_it_answers_every_dependency(lock: str, repository: Path) -> None:
    pinned: dict[str, list[Version]] = {}
    for name, version in PIN.findall(lock):
        pinned.setdefault(name, []).append(Version(version))
    project = tomllib.loads((repository / "pyproject.toml").read_text("utf-8"))["project"]
    extras = project["optional-dependencies"]
    for text in project["dependencies"] + extras["test"] + extras["video"] + extras["usd"]:
        requirement = Requirement(text)
        versions = pinned[requirement.name.lower()]
        assert all(requirement.specifier.contains(version) for version in versions), text


def test_it_holds_pins_and_hashes_and_no_place_to_load_from(lock: str) -> None:
    code = [line.split("#")[0] for line in lock.splitlines()]
    assert [line for line in code if not LINE.fullmatch(line)] == []
    assert "://" not in lock
