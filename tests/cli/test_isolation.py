"""The isolation level that `judge doctor` found is demanded by the commands after it."""

from __future__ import annotations

import json
import os
from dataclasses import replace

import pytest
from cli_support import FLOOR, MEAN, ROOT
from sampling import nightly

from judge.judging.containment import keep_level, kept_level
from judge.languages.find import Availability
from judge.sandbox import LEVELS, available
from judge.sandbox.available import levels_here
from judge.sandbox.visible import visible

pytestmark = pytest.mark.slow

BEST = next(level.name for level in levels_here() if level.available)


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    folder = tmp_path / "own-cache"
    monkeypatch.setenv("JUDGE_CACHE", str(folder))
    return folder


@pytest.fixture
def bare(tmp_path):
    """A PATH without bubblewrap."""
    if BEST != "full":
        pytest.skip(next(level.why_not for level in levels_here() if level.name == "full"))
    (tmp_path / "bin").mkdir()
    return str(tmp_path / "bin")


@pytest.mark.usefixtures("own_cache")
def test_bubblewrap_is_removed_and_nothing_drops_in_silence(process, submit, tmp_path, bare):
    file = str(tmp_path / submit(MEAN))
    assert process("doctor").lines[-1] == "Isolation: full"
    ended = process("run", "middle", file, file, "--json", PATH=bare)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == (
        "judge: isolation full, which 'judge doctor' found here, cannot be had: bubblewrap is not installed; "
        "install bubblewrap, or let 'judge doctor' look again\n"
    )
    for level in ("strong", "limits"):
        ended = process("run", "middle", file, "--json", "--isolation", level, PATH=bare)
        assert (ended.status, ended.err) == (0, "")
        assert json.loads(ended.out)["isolation"] == level
    assert process("verify", "middle", PATH=bare).status == 2
    assert process("doctor", PATH=bare).lines[-1] == "Isolation: strong"
    ended = process("run", "middle", file, "--json", PATH=bare)
    assert (ended.status, ended.err, json.loads(ended.out)["isolation"]) == (0, "", "strong")
    ended = process("run", "middle", file, "--json")
    assert (ended.status, ended.err, json.loads(ended.out)["isolation"]) == (0, "", "full")


@pytest.mark.usefixtures("own_cache")
def test_that_full_is_missing_is_said_once_a_day_on_a_terminal(submit, tmp_path, bare):
    from terminals import on_a_terminal

    file, note = str(tmp_path / submit(MEAN)), "Sandbox: strong, not full"
    for words, said in ((["-q"], 0), ([], 1), ([], 0)):
        status, shown = on_a_terminal("run", "middle", file, *words, PATH=bare)
        assert (status, shown.count(note)) == (0, said)


def test_the_doctor_keeps_what_it_found(judge, own_cache):
    assert kept_level() is None
    assert judge("doctor").status == 0
    assert kept_level() == BEST
    (file,) = (own_cache / "isolation").iterdir()
    file.write_bytes(file.read_bytes().replace(BEST.encode(), b"limits"))
    assert kept_level() is None, "nobody else writes it"
    assert judge("doctor").status == 0
    assert kept_level() == BEST


@pytest.mark.usefixtures("own_cache")
def test_a_shortage_while_the_doctor_looks_lowers_nothing(judge, monkeypatch):
    keep_level("full")
    found = (
        available.Level("full", available=False, meaning="", why_not="no memory", lasting=False),
        available.Level("strong", available=True, meaning=""),
        available.Level("limits", available=True, meaning=""),
    )
    monkeypatch.setattr("judge.cli.commands.doctor.levels_here", lambda _hide: found)
    assert judge("doctor").lines[-1] == "Isolation: strong"
    assert kept_level() == "full"
    monkeypatch.setattr(
        "judge.cli.commands.doctor.levels_here", lambda _hide: (replace(found[0], lasting=True), *found[1:])
    )
    judge("doctor")
    assert kept_level() == "strong"


@pytest.mark.usefixtures("own_cache")
def test_a_language_whose_tool_fails_is_told_with_its_reason(judge, monkeypatch):
    broken = Availability("Go", works=False, why_not="go does not say its version", remedy="repair it")
    monkeypatch.setattr("judge.cli.commands.doctor.found_of", lambda _language: broken)
    row = next(line for line in judge("doctor").lines if line.startswith("Go"))
    assert broken.why_not in row
    assert broken.remedy in row


def test_what_was_found_elsewhere_or_by_somebody_else_does_not_count(monkeypatch):
    keep_level("full")
    here = os.uname()
    for name, other in (
        ("uname", lambda: os.uname_result(("Linux", "elsewhere", *here[2:]))),
        ("uname", lambda: os.uname_result((*here[:2], "another kernel", *here[3:]))),
        ("geteuid", lambda: 12345),
    ):
        with monkeypatch.context() as patch:
            patch.setattr(os, name, other)
            assert kept_level() is None
    with monkeypatch.context() as patch:
        patch.setattr("judge.judging.containment.__version__", "99")
        assert kept_level() is None
    assert kept_level() == "full"
    with monkeypatch.context() as patch:  # a folder that two machines share keeps a level of each
        patch.setattr(os, "uname", lambda: os.uname_result(("Linux", "elsewhere", *here[2:])))
        keep_level("strong")
    assert kept_level() == "full"


# -- levels that are demanded ----------------------------------------------------------------------------


ACCEPTED = ROOT / "solutions" / "count" / "accepted"
OFFERED = [level.name for level in levels_here() if level.available]


def test_doctor_in_json(judge):
    found = json.loads(judge("doctor", "--json").out)
    assert found["isolation"] == OFFERED[0]
    assert [level["name"] for level in found["levels"]] == list(LEVELS)
    for level in found["levels"]:
        assert level["available"] == (level["why_not"] == "")
        assert (level["visible"] is not None) == level["available"]
        if level["available"]:
            assert (level["visible"] == "") == (level["name"] != "limits")


@pytest.fixture
def pack_among_modules(tmp_path, monkeypatch):
    """A pack of problems where modules are installed, which every container shows."""
    site = tmp_path / "site-packages"
    (site / "problems" / "one").mkdir(parents=True)
    (site / "problems" / "one" / "problem.toml").touch()
    monkeypatch.syspath_prepend(str(site))
    return site / "problems"


def test_doctor_names_what_a_level_fails_to_hide(judge, pack_among_modules, monkeypatch):
    found = visible()._replace(hidden=())
    monkeypatch.setattr("judge.sandbox.visible.visible", lambda *_arguments, **_options: found)
    weak = [
        level for level in json.loads(judge("doctor", "--json").out)["levels"] if level["name"] in OFFERED
    ]
    for level in weak[:-1]:
        assert (level["available"], level["visible"]) == (False, None)
        assert f"would let a submission read {pack_among_modules}" in level["why_not"]
        assert "virtual environment of its own" in level["remedy"]


@pytest.mark.parametrize("level", OFFERED)
def test_a_demanded_level_is_named_in_the_result(judge, level):
    ended = judge("run", "count", str(ACCEPTED / "quadratic.py"), "--isolation", level, "--json")
    result = json.loads(ended.out)
    assert (ended.status, result["verdict"], result["isolation"]) == (0, "AC", level)
    assert ended.err == ""  # who asks for less gets no warning


VERDICTS = {
    MEAN: "AC",
    "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n": "AC",
    """
import concurrent.futures, ctypes, dataclasses, decimal, fractions, functools, json, os, platform, random, re
import socket, statistics, subprocess, sys, tempfile, threading, time
sys.setrecursionlimit(20_000)
@functools.lru_cache(maxsize=None)
def deep(n):
    return n and deep(n - 1)
with concurrent.futures.ThreadPoolExecutor(4) as pool:
    assert [*pool.map(deep, range(4))] == [0, 0, 0, 0]
def middle(a, b):
    print(deep(2000), random.random(), time.monotonic(), os.getpid(), platform.machine(), file=sys.stderr)
    return float(sum(map(fractions.Fraction, (a, b))) / 2)
""": "AC",
    FLOOR: "WA",
    MEAN.replace("/ 2", "/ 0"): "RTE",
    f"import os\n{MEAN.replace('return', 'os._exit(0); return')}": "RTE",
    "def middle(a, b):\n    return len([0] * (1 << 33))\n": "MLE",
    "def middle(a, b)\n    return 1\n": "CE",
}


@pytest.mark.parametrize("level", OFFERED)
def test_a_program_has_one_verdict_at_every_level(judge, submit, level):
    files = [submit(source, f"p{place}.py") for place, source in enumerate(VERDICTS)]
    ended = judge("run", "middle", *files, "--json", "--no-shrink", "--no-name", "--isolation", level)
    assert [json.loads(row)["verdict"] for row in ended.lines] == [*VERDICTS.values()]
    assert {json.loads(row)["isolation"] for row in ended.lines} == {level}


def test_a_level_that_cannot_be_had_is_refused_with_a_remedy(judge, monkeypatch):
    monkeypatch.setattr("judge.sandbox.levels.missing", lambda _: "bubblewrap is not installed")
    ended = judge("run", "count", str(ACCEPTED / "quadratic.py"), "--isolation", "full")
    assert (ended.status, ended.out) == (2, "")
    assert "isolation full cannot be had here: bubblewrap is not installed" in ended.err


def test_weak_containment_is_warned_of_once(judge, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    monkeypatch.setattr("judge.sandbox.levels.missing", lambda level: "" if level == "limits" else "no")
    right = min((ROOT / "solutions" / "distance-squared" / "accepted").glob("*.py"))
    ended = judge("run", "distance-squared", str(right), "-q")
    assert ended.status == 0
    assert ended.err.count("isolation is 'limits'") == 1


@pytest.mark.parametrize("jobs", ["2", nightly("4")])
def test_several_at_once_come_in_order_with_the_same_verdicts(judge, submit, jobs):
    program = "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n"
    files = [
        submit(source, f"{name}.py")
        for name, source in zip("dcba", (MEAN, FLOOR, program, f"{FLOOR}#"), strict=True)
    ]
    ended = judge("run", "middle", *files, "--json", "-j", jobs, "--no-shrink", "--no-name")
    results = [json.loads(row) for row in ended.lines]
    assert [result["submission"] for result in results] == files
    assert [result["verdict"] for result in results] == ["AC", "WA", "AC", "WA"]


@pytest.mark.nightly
def test_an_accepted_submission_has_a_ratio(judge):
    result = json.loads(judge("run", "count", str(ACCEPTED / "exact.py"), "--json").out)
    ratio = result["time"]["ratio"]
    assert ratio["low"] <= ratio["median"] <= ratio["high"]
    assert ratio["pairs"] >= 3
    assert ratio["median"] > 2  # fractions against doubles: some ten times
    shown = judge("run", "count", str(ACCEPTED / "exact.py")).out
    assert "× the reference" in shown
