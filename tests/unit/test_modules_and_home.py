"""What a submission has besides Python: the folders of $JUDGE_PACKAGES, and an empty folder as its home."""

from __future__ import annotations

import os
import shutil

import pytest
from sandboxed import LIMITS, require, run

from judge.errors import UsageError
from judge.languages.boxes import AnyBoxes
from judge.sandbox import Containment

LEVELS = ["full", "strong"]
IMPORT = "import neighbour, sys\nprint(neighbour.VALUE, neighbour.__file__)"
WRITE = "import neighbour\ntry:\n    open(neighbour.__file__, 'a')\nexcept OSError:\n    print('held')"
AT_HOME = """
import os, pathlib, tempfile
home = pathlib.Path.home()
home.mkdir(parents=True, exist_ok=True)
assert os.access(home, os.W_OK), "matplotlib looks"
assert str(home) == os.environ["TMPDIR"] == os.environ["MPLCONFIGDIR"] != "~"
try:
    tempfile.gettempdir()
except FileNotFoundError:
    print(os.listdir(home))
"""


@pytest.fixture
def packages(tmp_path, monkeypatch):
    """A folder of modules, with one, and with what looks like a judge."""
    folder = tmp_path / "packages"
    (folder / "judge" / "sandbox").mkdir(parents=True)
    (folder / "judge" / "sandbox" / "boundary.py").write_text("SECRET = 1\n")
    (folder / "neighbour.py").write_text("VALUE = 42\n")
    monkeypatch.setenv("JUDGE_PACKAGES", os.pathsep.join(["", str(folder)]))
    return folder


@pytest.mark.parametrize("level", LEVELS)
def test_a_submission_imports_from_the_folders_that_are_named_and_changes_nothing_there(packages, level):
    require(level)
    assert run(IMPORT, level=level).stdout.decode() == f"42 {packages / 'neighbour.py'}\n"
    assert run(WRITE, level=level).stdout == b"held\n"


@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
@pytest.mark.parametrize("level", LEVELS)
def test_javascript_requires_from_a_node_modules_that_is_named(packages, tmp_path, monkeypatch, level):
    require(level)
    modules = tmp_path / "node_modules"
    (modules / "near").mkdir(parents=True)
    (modules / "near" / "index.js").write_text("exports.value = 42;\n")
    monkeypatch.setenv("JUDGE_PACKAGES", os.pathsep.join([str(packages), str(modules)]))
    with AnyBoxes(Containment(level))(b"process.stdout.write(`${require('near').value}`)", "a.js") as box:
        ended = box.run_program(b"", LIMITS)
    assert ended.stdout == b"42", ended


@pytest.mark.parametrize("level", LEVELS)
def test_a_judge_among_those_modules_is_hidden(packages, level):
    require(level)
    ended = run("import os, neighbour\nprint(os.listdir('%s'))" % (packages / "judge"), level=level)
    assert ended.stdout in (b"[]\n", b""), ended
    there = run("import neighbour\ntry: import judge\nexcept ModuleNotFoundError: print('none')", level=level)
    assert there.stdout == b"none\n", there


def test_a_folder_that_is_not_there_is_named(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_PACKAGES", f"{tmp_path}{os.pathsep}{tmp_path / 'gone'}")
    with pytest.raises(UsageError, match=f"JUDGE_PACKAGES names {tmp_path / 'gone'}, which is not a folder"):
        run("print(1)")


@pytest.mark.parametrize("level", LEVELS)
def test_its_home_is_an_empty_folder_that_looks_writable_and_is_not(level):
    require(level)
    ended = run(AT_HOME, level=level)
    assert ended.stdout == b"[]\n", ended


@pytest.mark.parametrize("level", ["strong", "limits"])
def test_its_home_goes_with_it(level):
    require(level)
    home = run("import os\nprint(os.environ['HOME'])", level=level).stdout.decode().strip()
    assert home
    assert not os.path.lexists(home)
