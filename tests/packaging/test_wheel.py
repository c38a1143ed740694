"""What is installed is what was written: the wheel, unpacked far from the checkout, judges."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

pytest.importorskip("hatchling", reason="hatchling is not installed")

ROOT = Path(__file__).parents[2]
PROBLEMS = {path.parent.name for path in ROOT.glob("problems/*/problem.toml")}


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """A pure wheel is installed by unpacking it."""
    place = tmp_path_factory.mktemp("site")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(place)
    return place


@pytest.fixture
def judge(installed, tmp_path, shared):
    def run(*words):
        cache = shared / "cache-of-the-wheel"
        environment = {**os.environ, "PYTHONPATH": str(installed), "JUDGE_CACHE": str(cache)}
        environment.pop("JUDGE_PROBLEMS", None)
        command = [sys.executable, "-m", "judge", *words]
        ended = subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300
        )
        assert ended.stderr == ""
        return ended.returncode, [json.loads(line) for line in ended.stdout.splitlines()]

    return run


def test_it_holds_the_package_and_every_file_of_problems_and_solutions_and_nothing_else(wheel, installed):
    names = set(zipfile.ZipFile(wheel).namelist())
    wanted = {"judge/py.typed", "judge/__init__.py", "judge/__main__.py", "judge/schema/files/cards.json"}
    for folder in ("judge/report/html/templates", "judge/manual", "judge/languages", "problems", "solutions"):
        for path in (ROOT / folder).rglob("*"):
            if path.is_file() and not {"__pycache__", "libraries"} & {*path.parts}:
                wanted.add(f"judge/{path.relative_to(ROOT).as_posix().removeprefix('judge/')}")
    assert wanted <= names
    tops = {name.split("/")[0] for name in names} - {"judge"}
    assert [top.endswith(".dist-info") for top in tops] == [True]
    assert not [name for name in names if "__pycache__" in name or "/libraries/" in name]
    (entry_points,) = installed.glob("*.dist-info/entry_points.txt")
    assert "judge = judge.cli:main" in entry_points.read_text()
    assert "[pytest11]\njudge = judge.pytest_plugin" in entry_points.read_text()


def test_it_finds_its_problems_rejects_a_wrong_program_and_accepts_its_own_solution(
    judge, installed, tmp_path
):
    status, found = judge("list", "--json")
    assert (status, {each["problem"] for each in found}) == (0, PROBLEMS)
    wrong, right = tmp_path / "mine.py", installed / "judge/solutions/circle-side/accepted"
    wrong.write_text("def circle_side(*given):\n    return 1\n")
    for file, wanted in ((wrong, (1, "WA")), (sorted(right.glob("*.py"))[0], (0, "AC"))):
        status, (result,) = judge("run", "circle-side", str(file), "--json", "--no-name")
        assert (status, result["verdict"]) == wanted


AUTHOR = """
import pytest
from hypothesis import given, settings
from judge.testing import judge_problem
from mylib import line_count

COUNT = judge_problem("count")

@pytest.mark.judge_problem("count")
def test_group(judge_group):
    judge_group.check(line_count, seconds=120)

@pytest.mark.parametrize("case", COUNT.cases("examples"), ids=repr)
def test_case(case):
    assert case.accepts(line_count(*case))

@settings(max_examples=20, deadline=None)
@given(COUNT.strategy("near"))
def test_near(case):
    assert case.accepts(line_count(*case))

def test_result():
    result = COUNT.judge(lambda *_: 2)
    assert (result.verdict.value, result.cut_short) == ("WA", False)
"""


def test_a_library_author_tests_with_it_in_several_processes(installed, tmp_path, shared):
    right = (ROOT / "solutions/count/accepted/tolerant.py").read_text(encoding="utf-8")
    (tmp_path / "mylib.py").write_text(right, encoding="utf-8")
    (tmp_path / "test_mylib.py").write_text(AUTHOR, encoding="utf-8")
    path = os.pathsep.join(map(str, (installed, tmp_path)))
    environment = {**os.environ, "PYTHONPATH": path, "JUDGE_CACHE": str(shared / "cache-of-the-wheel")}
    environment.pop("JUDGE_PROBLEMS", None)
    words = [sys.executable, "-m", "pytest", "-q", "-n", "2", "--rootdir", str(tmp_path)]
    ended = subprocess.run(
        words, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    groups = len(json.loads((ROOT / "problems/count/pins.json").read_text()))
    assert f"{groups + 10} passed" in ended.stdout, ended.stdout


@pytest.mark.nightly
def test_its_wrong_programs_can_be_broken(judge):
    """The solutions are hidden from what runs in the box, and the one to break is read outside of it."""
    status, (found,) = judge("hack", "count", "forgotten-abs", "0 0 1 -1 -1 1 -1", "--json")
    assert (status, found["outcome"], found["said"]["got"]) == (0, "won", "2")


@pytest.mark.nightly
def test_a_source_distribution_has_the_five_top_level_names(tmp_path):
    command = [sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", str(tmp_path)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, timeout=120)
    (built,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(built) as archive:
        tops = {name.split("/")[1] for name in archive.getnames() if "/" in name}
    assert {"pyproject.toml", "README.md", "judge", "problems", "solutions", "tests"} <= tops
