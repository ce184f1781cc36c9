"""What a user installs is all of Risorius."""

import zipfile
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

PACKAGES = ("fem", "facemodel", "app", "ui", "resources")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory, repository: Path) -> zipfile.ZipFile:
    folder = tmp_path_factory.mktemp("wheel")
    (path,) = WheelBuilder(str(repository)).build(directory=str(folder), versions=["standard"])
    return zipfile.ZipFile(path)


def test_every_file_of_the_packages_is_in_the_wheel(wheel: zipfile.ZipFile, repository: Path) -> None:
    files = (path for package in PACKAGES for path in (repository / package).rglob("*") if path.is_file())
    names = {path.relative_to(repository).as_posix() for path in files if "__pycache__" not in path.parts}
    assert names
    assert names - set(wheel.namelist()) == set()


def test_the_wheel_has_the_command_and_the_licence(wheel: zipfile.ZipFile) -> None:
    files = {name.split("/", 1)[1]: name for name in wheel.namelist() if ".dist-info/" in name}
    assert "risorius = ui.launch:main" in wheel.read(files["entry_points.txt"]).decode()
    assert wheel.read(files["licenses/LICENSE"]).startswith(b"MIT License")


def test_the_wheel_has_nothing_else(wheel: zipfile.ZipFile) -> None:
    tops = {name.split("/")[0] for name in wheel.namelist()}
    assert {top for top in tops if not top.endswith(".dist-info")} <= set(PACKAGES)
