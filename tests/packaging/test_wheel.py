"""What is installed is what was written: the wheel, unpacked far from the checkout, judges."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

pytest.importorskip("hatchling")

ROOT = Path(__file__).parents[2]
TEMPLATES = ROOT / "judge" / "report" / "page" / "templates"
PROBLEMS = {path.parent.name for path in ROOT.glob("problems/*/problem.toml")}


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """A pure wheel is installed by unpacking it."""
    place = tmp_path_factory.mktemp("site")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(place)
    return place


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture
def judge(installed, tmp_path, cache):
    def run(*words):
        environment = {**os.environ, "PYTHONPATH": str(installed), "JUDGE_CACHE": str(cache)}
        environment.pop("JUDGE_PROBLEMS", None)
        command = [sys.executable, "-m", "judge", *words]
        ended = subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
        )
        assert ended.stderr == ""
        return ended.returncode, [json.loads(line) for line in ended.stdout.splitlines()]

    return run


def test_it_holds_the_package_and_every_file_of_problems_and_solutions(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    wanted = {"judge/py.typed", "judge/__init__.py", "judge/__main__.py", "judge/schema/run.json"}
    wanted |= {f"judge/report/page/templates/{path.name}" for path in TEMPLATES.iterdir()}
    wanted |= {f"judge/manual/{path.name}" for path in (ROOT / "judge" / "manual").glob("*.*")}
    for folder in ("problems", "solutions"):
        for path in (ROOT / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                wanted.add(f"judge/{path.relative_to(ROOT).as_posix()}")
    assert wanted <= names


def test_it_holds_nothing_else(wheel):
    tops = {name.split("/")[0] for name in zipfile.ZipFile(wheel).namelist()}
    assert len(tops) == 2
    assert tops - {"judge"} == {top for top in tops if top.endswith(".dist-info")}
    assert not [name for name in zipfile.ZipFile(wheel).namelist() if "__pycache__" in name]


def test_the_console_script(installed):
    (entry_points,) = installed.glob("*.dist-info/entry_points.txt")
    assert "judge = judge.cli:main" in entry_points.read_text()
    assert "[pytest11]\njudge = judge.pytest_plugin" in entry_points.read_text()


def test_it_is_the_unpacked_one_that_runs(installed, tmp_path):
    command = [sys.executable, "-c", "import judge; print(judge.__file__)"]
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    ended = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=True, timeout=60
    )
    assert Path(ended.stdout.strip()).is_relative_to(installed)


def test_it_finds_its_problems(judge):
    status, found = judge("list", "--json")
    assert status == 0
    assert {each["problem"] for each in found} == PROBLEMS


def test_it_rejects_a_wrong_program_and_accepts_its_own_solution(judge, installed, tmp_path):
    (tmp_path / "mine.py").write_text("def line_count(cx, cy, r, A, B):\n    return 1 if A != B else None\n")
    status, (result,) = judge("run", "count", "mine.py", "--json")
    assert (status, result["verdict"]) == (1, "WA")
    (solution, *_) = sorted((installed / "judge" / "solutions" / "count" / "accepted").glob("*.py"))
    status, (result,) = judge("run", "count", str(solution), "--json")
    assert (status, result["verdict"], result["score"]) == (0, "AC", 100)


def test_its_wrong_programs_can_be_broken(judge):
    """The solutions are hidden from what runs in the box, and the one to break is read outside of it."""
    status, (found,) = judge("hack", "count", "forgotten-abs", "0 0 1 -1 -1 1 -1", "--json")
    assert (status, found["outcome"], found["case"]["got"]) == (0, "won", "2")


def test_a_source_distribution_has_the_five_top_level_names(tmp_path):
    import tarfile

    command = [sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", str(tmp_path)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, timeout=120)
    (built,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(built) as archive:
        tops = {name.split("/")[1] for name in archive.getnames() if "/" in name}
    assert {"pyproject.toml", "README.md", "judge", "problems", "solutions", "tests"} <= tops
