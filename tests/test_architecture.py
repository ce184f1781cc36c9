"""The rules of the house that no other tool holds."""

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("fem", "facemodel", "app", "ui", "resources")
WITHOUT_A_SCREEN = ("fem", "facemodel", "app", "resources")
SCREEN = {"PySide6", "shiboken6", "qtpy", "superqt", "qtawesome", "vtk", "vtkmodules", "pyvista", "pyvistaqt"}

# Reading these back runs whatever they hold, and a project may come from anywhere.
UNSAFE_MODULES = {"pickle", "cPickle", "marshal", "shelve", "dill", "joblib"}
UNSAFE_CALLS = {"eval", "exec", "compile", "__import__"}

# The console runs what its user types, and nothing else: no other module may run text as code, and none reads it.
INTERPRETERS = {"code", "codeop", "runpy"}
CONSOLE = "app/scripting/console.py"

# A file holds one idea and a function fits on a screen.
LONGEST_FILE = 300
LONGEST_FUNCTION = 40

LOADED_AFTER_IMPORT = """
import importlib, pkgutil, sys
for package in sys.argv[1:]:
    for module in pkgutil.walk_packages(importlib.import_module(package).__path__, package + "."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
print(*sys.modules)
"""


def loaded_in_a_fresh_interpreter(code: str, *arguments: str) -> set[str]:
    command = [sys.executable, "-c", code, *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return set(done.stdout.split())


def modules_of(package: str) -> set[str]:
    """Return the dotted names of all modules of a package, by its files."""
    paths = [path.relative_to(ROOT).with_suffix("").parts for path in (ROOT / package).rglob("*.py")]
    names = {".".join(part for part in parts if part != "__init__") for parts in paths}
    return {name for name in names if not name.endswith("__main__")}


@cache
def syntax_trees(*packages: str) -> tuple[tuple[str, str, ast.Module], ...]:
    """Return the name, the text and the syntax tree of every source of these packages."""
    found = []
    for package in packages:
        for path in sorted((ROOT / package).rglob("*.py")):
            text = path.read_text("utf-8")
            found.append((path.relative_to(ROOT).as_posix(), text, ast.parse(text)))
    return tuple(found)


@pytest.mark.parametrize("package", WITHOUT_A_SCREEN)
def test_importing_it_loads_neither_qt_nor_vtk(package: str) -> None:
    loaded = loaded_in_a_fresh_interpreter(LOADED_AFTER_IMPORT, package)
    assert modules_of(package) <= loaded
    assert not {module.split(".")[0] for module in loaded} & SCREEN


def test_the_command_loads_neither_qt_nor_vtk_before_they_are_asked_for() -> None:
    loaded = loaded_in_a_fresh_interpreter("import sys, ui.launch; print(*sys.modules)")
    assert "app.cli" in loaded
    assert not {module.split(".")[0] for module in loaded} & SCREEN


def runs_what_it_reads(node: ast.AST) -> bool:
    match node:
        case ast.Import(names=names):
            return not UNSAFE_MODULES.isdisjoint(alias.name.split(".")[0] for alias in names)
        case ast.ImportFrom(module=str(module)):
            return module.split(".")[0] in UNSAFE_MODULES
        case ast.Call(func=ast.Name(id=name)) if name in UNSAFE_CALLS:
            return True
        case ast.keyword(arg="allow_pickle", value=value):
            return ast.unparse(value) != "False"
    return False


@pytest.mark.parametrize(
    "line",
    ["import pickle", "from marshal import loads", "eval('1')", "np.load(f, allow_pickle=True)"],
)
def test_the_search_for_unsafe_code_finds_it(line: str) -> None:
    assert any(runs_what_it_reads(node) for node in ast.walk(ast.parse(line)))


def test_no_source_can_run_what_it_reads() -> None:
    found = [
        f"{name}: {ast.unparse(node)}"
        for name, _, tree in syntax_trees(*PACKAGES)
        for node in ast.walk(tree)
        if runs_what_it_reads(node)
    ]
    assert found == []


def imported_by(node: ast.AST) -> set[str]:
    """Return the names of the modules that a statement imports."""
    match node:
        case ast.Import(names=names):
            return {alias.name for alias in names}
        case ast.ImportFrom(module=str(module)):
            return {module}
    return set()


def test_only_the_console_runs_text_and_it_reads_no_file() -> None:
    importing = {
        name
        for name, _, tree in syntax_trees(*PACKAGES)
        for node in ast.walk(tree)
        if not INTERPRETERS.isdisjoint(imported_by(node))
    }
    assert importing == {CONSOLE}
    tree = ast.parse((ROOT / CONSOLE).read_text("utf-8"))
    called = {ast.unparse(node.func).split(".")[-1] for node in ast.walk(tree) if isinstance(node, ast.Call)}
    assert called.isdisjoint({"open", "read_text", "read_bytes", "read_file"})


def lines_of_code(function: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    """Count the lines of a function's body below its docstring."""
    body = function.body
    first = body[1] if ast.get_docstring(function) is not None and len(body) > 1 else body[0]
    return body[-1].end_lineno - first.lineno + 1


def test_files_stay_short() -> None:
    lengths = {name: text.count("\n") for name, text, _ in syntax_trees(*PACKAGES)}
    assert {name: length for name, length in lengths.items() if length > LONGEST_FILE} == {}


def test_functions_stay_short() -> None:
    lengths = {
        f"{name}:{node.lineno} {node.name}": lines_of_code(node)
        for name, _, tree in syntax_trees(*PACKAGES)
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    assert {name: length for name, length in lengths.items() if length > LONGEST_FUNCTION} == {}
