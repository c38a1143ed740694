"""Packages of other judges that ask for too much: limits are bounded, and no validator holds the judge up."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from foreign_packages import LEGACY, NEW, RIGHT, WRONG, written
from jsonschema import Draft202012Validator
from sampling import daily, nightly

from judge.cli import packages
from judge.errors import ProblemError
from judge.packs.foreign import checker, timing
from judge.packs.foreign.cases import test_files as files_of
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import OURS, THEIRS, read_package
from judge.packs.foreign.timing import TimeLimit, limit_of
from judge.report import live
from judge.sandbox import levels, room
from judge.schema import schema_of

MB = 1 << 20
QUICK = "validation_time: 1, validation_memory: 64"
SLEEPS = "import time\ntime.sleep(1e9)\n"
WORKS = "while True: pass\n"
EATS = "kept = []\nwhile True:\n    kept.append(b'x' * (1 << 20))\n"
WRITES = """
import sys
number = 0
while True:
    number += 1
    with open(sys.argv[3] + str(number), "wb") as file:
        file.write(bytes(1 << 16))
"""
DIGS = """
import os, sys
here = os.open(sys.argv[3], os.O_RDONLY)
for _ in range(5000):
    os.mkdir("d", dir_fd=here)
    there = os.open("d", os.O_RDONLY, dir_fd=here)
    os.close(here)
    here = there
"""
HIDES = """
import os, sys
for number in range(1000):
    os.mkdir(f"{sys.argv[3]}{number}", 0)
raise SystemExit(42)
"""
FORKS = """
import os, sys
for _ in range(20):
    if os.fork() == 0:
        kept = b"x" * (50 << 20)
        os._exit(0)
sys.exit(42)
"""

LEVELS = [level.name for level in levels() if level.available]


@pytest.fixture
def package(tmp_path):
    def make(limits, check=None, *more):
        parts = {"problem.yaml": f"problem_format_version: 2025-09\nlimits: {{time_limit: 2, {limits}}}"}
        if check is not None:
            parts["output_validator/check.py"] = check
        return str(written(tmp_path / "sum", NEW, parts, *more))

    return make


def asked(limits, tmp_path, bounds=OURS, base=NEW):
    text = (
        f"problem_format_version: 2025-09\nlimits: {{{limits}}}" if base is NEW else f"limits: {{{limits}}}"
    )
    return read_package(Opened(str(written(tmp_path / "sum", base, {"problem.yaml": text}))), bounds)


def rows(ended):
    found = [json.loads(line) for line in ended.lines]
    for row in found:
        Draft202012Validator(schema_of("run")).validate(row)
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("source", "why"), [(SLEEPS, "took more than 2 s"), nightly(WORKS, "s of CPU time")])
def test_the_first_validator_that_hangs_ends_the_judging_with_its_name(package, judge, submit, source, why):
    ended = judge("run", package(QUICK, source), submit(RIGHT, "a.py"), submit(WRONG, "b.py"), "--json")
    first, second = rows(ended)
    named = "the output validator output_validator "
    assert (ended.status, first["verdict"], second["verdict"]) == (3, "JE", "JE")
    assert first["failure"]["test"] == "sample/1"
    assert first["failure"]["message"].startswith(named)
    assert why in first["failure"]["message"]
    assert second["failure"]["message"].startswith(f"not judged: {named}")
    assert not second["tests"]


@pytest.mark.nightly
@pytest.mark.slow
def test_one_that_hangs_on_accepted_submissions_is_not_asked_again(tmp_path, judge, submit):
    parts = {
        "problem.yaml": "validation: custom\nlimits: {validation_time: 1}",
        "output_validators/check.py": SLEEPS,
        **{f"submissions/accepted/{name}.py": f"# {name}\n{RIGHT}" for name in "bcd"},
    }
    ended = judge("run", written(tmp_path / "sum", LEGACY, parts), submit(RIGHT, "a.py"), "--json")
    (row,) = rows(ended)
    assert "not judged: the output validator output_validators/check.py" in row["failure"]["message"]
    assert "accepts none of them" not in ended.err


@pytest.mark.slow
def test_the_first_accepted_submission_that_hangs_ends_the_search_for_a_time_limit(
    tmp_path, judge, submit, monkeypatch
):
    short = TimeLimit(0.5, 0.5)
    for module in (packages, timing):
        monkeypatch.setattr(module, "UNKNOWN", short)
    hangs = {f"submissions/accepted/{name}.py": f"# {name}\n{WORKS}" for name in "abc"}
    root = written(tmp_path / "sum", LEGACY, hangs)
    ended = judge("run", root, submit(RIGHT, "mine.py"), "--json")
    (row,) = rows(ended)
    assert row["verdict"] == "AC"
    why = "submissions/accepted/a.py is too slow on sample/1 to set the time limit: it is 0.5 s"
    assert why in ended.err
    assert "b.py" not in ended.err


@pytest.mark.nightly
@pytest.mark.slow
def test_one_that_waits_a_little_on_each_of_many_files_hangs_too(package, judge, submit, monkeypatch):
    monkeypatch.setattr(checker, "_IDLE_SECONDS", 1.0)
    many = {
        f"data/secret/{n}.{end}": LEGACY[f"data/sample/1.{end}"]
        for n in range(2, 40)
        for end in ("in", "ans")
    }
    source = "import time\ntime.sleep(1.5)\nraise SystemExit(42)"
    ended = judge("run", package("validation_time: 2", source, many), submit(RIGHT, "a.py"), "--json")
    (row,) = rows(ended)
    assert "has waited" in row["failure"]["message"]
    assert len(row["tests"]) < 38


@pytest.mark.slow
@pytest.mark.parametrize(
    ("source", "why"),
    [
        (EATS, "used more than 64 MB|MemoryError"),
        (WRITES, "left more files than it may"),
        (DIGS, "left more files than it may"),
        (HIDES, "left more files than it may|cannot be read"),
        (FORKS, "Operation not permitted|used more than 64 MB"),
    ],
)
@pytest.mark.parametrize("level", daily(LEVELS, LEVELS[:1]))
def test_a_validator_is_held_and_leaves_nothing(
    package, judge, submit, source, why, level, tmp_path, monkeypatch
):
    if level == "limits" and source is FORKS:
        pytest.skip("nothing is refused there")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "tmp"))
    (tmp_path / "tmp").mkdir()
    ended = judge("run", package(QUICK, source), submit(RIGHT, "a.py"), "--json", "--isolation", level)
    (row,) = rows(ended)
    assert (ended.status, row["verdict"]) == (3, "JE"), row
    assert any(each in row["failure"]["message"] for each in why.split("|")), row
    assert list((tmp_path / "tmp").iterdir()) == []


def test_limits_beyond_ours_are_ours_and_that_is_said(tmp_path):
    validating = "validation_time: 3600, validation_memory: 9999, validation_output: 99"
    found = asked(f"memory: 1048576, output: 256, {validating}", tmp_path)
    assert found.memory_bytes <= OURS.memory * MB
    assert found.output_bytes == OURS.output * MB
    assert found.validating.wall_seconds == OURS.validating + 1
    assert found.validating.cpu_seconds == OURS.validating
    assert set(found.lowered) == {
        "memory",
        "output",
        "validation_time",
        "validation_memory",
        "validation_output",
    }
    assert all("--package-limits" in said or "this machine" in said for said in found.lowered.values())
    assert asked("", tmp_path).lowered == {}


def test_a_flag_raises_them_as_far_as_the_machine_goes(tmp_path, judge, submit):
    text = "memory: 1048576, output: 256, validation_time: 3600"
    found = asked(text, tmp_path, THEIRS)
    assert (found.output_bytes, found.validating.cpu_seconds) == (256 * MB, 3600)
    assert found.memory_bytes < room.memory_left()
    assert set(found.lowered) == {"memory"}
    assert "this machine allows" in found.lowered["memory"]
    ended = judge("run", "middle", submit(RIGHT, "a.py"), "--package-limits")
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert "goes with a package" in ended.err


def test_memory_is_what_the_machine_has(tmp_path, monkeypatch):
    monkeypatch.setattr(room, "memory_left", lambda: 1024 * MB)
    found = asked("", tmp_path)
    assert found.memory_bytes == 256 * MB
    assert "this machine allows 256" in found.lowered["memory"]
    monkeypatch.setattr(room, "memory_left", lambda: 0)
    assert asked("", tmp_path).memory_bytes == MB


@pytest.mark.slow
def test_a_verdict_under_a_lower_limit_says_so(package, judge, submit, monkeypatch):
    monkeypatch.setattr(room, "memory_left", lambda: 640 * MB)
    eats = "kept = b'x' * (100 << 20)\n" + RIGHT
    ended = judge("run", package("memory: 2000"), submit(eats, "a.py"), "--json")
    (row,) = rows(ended)
    assert row["verdict"] == "MLE"
    assert "limits.memory is 2,000 MB, and this machine allows 64" in row["failure"]["message"]
    assert row["limits"]["lowered"]
    assert "limits.memory is 2,000 MB" in ended.err


@pytest.mark.parametrize(
    ("limits", "slowest", "seconds"),
    [("time_limit: 3600", None, 60), ("time_multiplier: 1000", 3.0, 60), ("time_limit: 50", None, 50)],
)
def test_the_time_limit_has_a_bound(tmp_path, limits, slowest, seconds):
    base = NEW if slowest is None else LEGACY
    limit = limit_of(asked(limits, tmp_path, base=base).time, slowest)
    assert (limit.seconds, limit.margin) == (seconds, 60)
    assert bool(limit.lowered) == (seconds == 60)
    limit = limit_of(asked(limits, tmp_path, THEIRS, base).time, slowest)
    assert limit.seconds == limit.wanted


def test_test_files_are_bounded_together_before_one_is_read(tmp_path):
    root = written(tmp_path / "sum", NEW)
    for number in range(2, 8):
        with (root / f"data/secret/{number}.in").open("wb") as file:
            file.truncate(200 * MB)
        (root / f"data/secret/{number}.ans").write_text("")
    with pytest.raises(ProblemError, match=r"larger than 1,024 MB; --package-limits allows more"):
        files_of(read_package(Opened(str(root))))
    assert len(files_of(read_package(Opened(str(root)), THEIRS))) == 8


@pytest.mark.slow
def test_how_far_it_is_is_shown(package, judge, submit, monkeypatch):
    monkeypatch.setattr(live, "is_terminal", lambda _: True)
    monkeypatch.setenv("TERM", "xterm")
    ended = judge("run", package(""), submit(RIGHT, "a.py"), submit(WRONG, "b.py"))
    assert "0 of 2 judged, a.py on sample/1, 0 of 2 test files" in ended.err
    assert "1 of 2 judged, b.py on sample/1, 0 of 2 test files" in ended.err
    assert ended.err.endswith("\r\x1b[K")


def test_the_manual_says_the_bounds():
    page = Path("judge/manual/packages.md")
    text = (Path(__file__).parents[2] / page).read_text(encoding="utf-8")
    for number in (
        f"{OURS.memory:,.0f} MB",
        f"{OURS.output:.0f} MB",
        f"{OURS.seconds:.0f} s",
        "--package-limits",
    ):
        assert number in text, number
