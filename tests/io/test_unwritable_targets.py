"""A save that fails says why and leaves the previous file and the folder as they were."""

import os
import shutil
import stat
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from facemodel.errors import ProjectError
from facemodel.io.disk import replacing
from facemodel.io.project_file import load_project, save_project
from tests.io.small_project import identical, small_project

posix = pytest.mark.skipif(os.name == "nt", reason="rights and limits of POSIX systems")
NOBODY = 65534


@pytest.fixture
def own_folder() -> Iterator[Path]:
    """A folder of a user who may not write everywhere; root becomes nobody for the test."""
    folder = Path(tempfile.mkdtemp(prefix="risorius-"))
    root = os.geteuid() == 0
    if root:
        os.chown(folder, NOBODY, NOBODY)
        os.setresuid(NOBODY, NOBODY, 0)
    yield folder
    if root:
        os.setresuid(0, 0, 0)
    folder.chmod(0o700)
    shutil.rmtree(folder)


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of 12 KiB, where the system lets us make one."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=12k", "tmpfs", str(disk)]
    if shutil.which("mount") is None or subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("no right to mount a small disk")
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


LIMITED = """
import resource, sys
from pathlib import Path
from facemodel.errors import ProjectError
from facemodel.io.project_file import save_project
from tests.io.small_project import small_project
resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
try:
    save_project(small_project().posed({}), Path(sys.argv[1]))
except ProjectError as error:
    print(error)
"""


@posix
def test_a_full_disk_leaves_the_previous_file(small_disk: Path) -> None:
    path = small_disk / "smile.risorius"
    save_project(small_project(), path)
    before = path.read_bytes()
    with pytest.raises(ProjectError, match="the disk is full; free some space or choose another disk") as caught:
        save_project(small_project().posed({}), path)
    assert str(path) in str(caught.value)
    assert path.read_bytes() == before
    assert os.listdir(small_disk) == ["smile.risorius"]


@posix
def test_a_write_that_stops_half_way_leaves_the_previous_file(tmp_path: Path) -> None:
    """The limit on the size of files stops the write half way, as a full disk does."""
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    before = path.read_bytes()
    run = subprocess.run(
        [sys.executable, "-c", LIMITED, str(path)], capture_output=True, text=True, check=True, cwd=Path.cwd()
    )
    assert str(path) in run.stdout
    assert "larger than this system allows; choose another disk" in run.stdout
    assert path.read_bytes() == before
    assert os.listdir(tmp_path) == ["smile.risorius"]


@posix
def test_a_folder_without_permission(own_folder: Path) -> None:
    own_folder.chmod(0o500)
    with pytest.raises(ProjectError, match="permission is denied; change the permissions"):
        save_project(small_project(), own_folder / "smile.risorius")


@posix
def test_a_write_protected_file(own_folder: Path) -> None:
    path = own_folder / "smile.risorius"
    path.write_text("precious")
    path.chmod(0o400)
    with pytest.raises(ProjectError, match="write-protected"):
        save_project(small_project(), path)
    assert path.read_text() == "precious"


def test_a_missing_folder(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"there is no folder .*none.*; create it"):
        save_project(small_project(), tmp_path / "none" / "smile.risorius")


def test_a_file_in_the_place_of_a_folder(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(ProjectError, match="cannot be saved"):
        save_project(small_project(), tmp_path / "file" / "smile.risorius")


def test_a_folder_in_the_place_of_the_file(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="is a folder; choose another name"):
        save_project(small_project(), tmp_path)
    assert os.listdir(tmp_path) == []


@posix
def test_a_pipe_is_not_replaced(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(ProjectError, match="a device or a pipe"):
        save_project(small_project(), pipe)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_names_that_cannot_be(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="name is too long; choose a shorter one"):
        save_project(small_project(), tmp_path / ("n" * 300))
    with pytest.raises(ProjectError, match="cannot be saved"):
        save_project(small_project(), tmp_path / "nul\0.risorius")
    assert os.listdir(tmp_path) == []


@posix
def test_links_are_followed_and_circles_noticed(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    link = tmp_path / "link.risorius"
    link.symlink_to(tmp_path / "far" / "real.risorius")
    save_project(small_project(), link)
    assert link.is_symlink()
    assert identical(load_project(tmp_path / "far" / "real.risorius"), small_project())
    (tmp_path / "a").symlink_to(tmp_path / "b")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    with pytest.raises(ProjectError, match="circle"):
        save_project(small_project(), tmp_path / "a")


@posix
def test_the_permissions_of_the_previous_file_stay(tmp_path: Path) -> None:
    path = tmp_path / "smile.risorius"
    path.write_text("")
    path.chmod(0o640)
    save_project(small_project(), path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_an_interrupted_write_leaves_the_previous_file(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_text("precious")

    def write_half() -> None:
        with replacing(path) as stream:
            stream.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_half()
    assert path.read_text() == "precious"
    assert os.listdir(tmp_path) == ["file"]
