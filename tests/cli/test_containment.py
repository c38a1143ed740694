"""`judge doctor`, `--isolation` and `-j`, through the command line."""

from __future__ import annotations

import json

import pytest
from cli_support import ROOT
from mistaken import mistaken
from sampling import nightly

from judge.sandbox import LEVELS, levels
from judge.sandbox.roots import find_roots

pytestmark = pytest.mark.slow

ACCEPTED = ROOT / "solutions" / "count" / "accepted"
OFFERED = [level.name for level in levels() if level.available]


def test_doctor_names_every_level_and_the_one_in_use_last(judge):
    ended = judge("doctor")
    assert ended.status == 0
    assert all(f"\n{level} " in ended.out for level in LEVELS)
    assert ended.out.splitlines()[-1] == f"isolation is {OFFERED[0]}"


def test_doctor_in_json(judge):
    found = json.loads(judge("doctor", "--json").out)
    assert found["isolation"] == OFFERED[0]
    assert [level["name"] for level in found["levels"]] == list(LEVELS)
    for level in found["levels"]:
        assert level["available"] == (level["why_not"] is None)
        assert level["hides"] == (level["name"] != "limits" if level["available"] else None)
        assert (level["visible"] is None) == (level["hides"] is not False)


@pytest.fixture
def pack_among_modules(tmp_path, monkeypatch):
    """A pack of problems where modules are installed, which every container shows."""
    site = tmp_path / "site-packages"
    (site / "problems" / "one").mkdir(parents=True)
    (site / "problems" / "one" / "problem.toml").touch()
    monkeypatch.syspath_prepend(str(site))
    return site / "problems"


def test_doctor_names_what_a_level_fails_to_hide(judge, pack_among_modules, monkeypatch):
    found = find_roots()._replace(hidden=())
    monkeypatch.setattr("judge.sandbox.roots.find_roots", lambda _hide: found)
    weak = [
        level for level in json.loads(judge("doctor", "--json").out)["levels"] if level["name"] in OFFERED
    ]
    for level in weak[:-1]:
        assert (level["available"], level["hides"]) == (False, None)
        assert f"would let a submission read {pack_among_modules}" in level["why_not"]
        assert "virtual environment of its own" in level["remedy"]


@pytest.mark.parametrize("level", OFFERED)
def test_a_demanded_level_is_named_in_the_result(judge, level):
    ended = judge("run", "count", str(ACCEPTED / "quadratic.py"), "--isolation", level, "--json")
    result = json.loads(ended.out)
    assert (ended.status, result["verdict"], result["isolation"]) == (0, "AC", level)
    assert ended.err == ""  # who asks for less gets no warning


def test_a_level_that_cannot_be_had_is_refused_with_a_remedy(judge, monkeypatch):
    monkeypatch.setattr("judge.sandbox.probe.missing", lambda _: "bubblewrap is not installed")
    ended = judge("run", "count", str(ACCEPTED / "quadratic.py"), "--isolation", "full")
    assert (ended.status, ended.out) == (2, "")
    assert "isolation full cannot be had here: bubblewrap is not installed" in ended.err


def test_weak_containment_is_warned_of_once(judge, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    monkeypatch.setattr("judge.sandbox.probe.missing", lambda level: "" if level == "limits" else "no")
    right = min((ROOT / "solutions" / "distance-squared" / "accepted").glob("*.py"))
    ended = judge("run", "distance-squared", str(right), "-q")
    assert ended.status == 0
    assert ended.err.count("isolation is 'limits'") == 1


@pytest.fixture
def wrong(tmp_path):
    """A folder with two wrong programs."""
    for name in ("loose-epsilon", "tangent-twice"):
        (tmp_path / f"{name}.py").write_bytes(mistaken("count", name))
    return tmp_path


@pytest.mark.parametrize("jobs", ["2", nightly("4")])
def test_several_at_once_come_in_order_with_the_same_verdicts(judge, jobs, wrong):
    files = [
        ACCEPTED / "exact.py",
        wrong / "loose-epsilon.py",
        ACCEPTED / "program.py",
        wrong / "tangent-twice.py",
    ]
    ended = judge("run", "count", *map(str, files), "--json", "-j", jobs)
    results = [json.loads(row) for row in ended.out.splitlines()]
    assert [result["submission"] for result in results] == list(map(str, files))
    assert [result["verdict"] for result in results] == ["AC", "WA", "AC", "WA"]
    assert results[1]["failure"]["group"] == "near-hit"


@pytest.mark.nightly
def test_an_accepted_submission_has_a_ratio(judge):
    result = json.loads(judge("run", "count", str(ACCEPTED / "exact.py"), "--json").out)
    ratio = result["time"]["ratio"]
    assert ratio["low"] <= ratio["median"] <= ratio["high"]
    assert ratio["pairs"] >= 3
    assert ratio["median"] > 2  # fractions against doubles: some ten times
    shown = judge("run", "count", str(ACCEPTED / "exact.py")).out
    assert "× the reference (" in shown.splitlines()[-1] + shown.splitlines()[-2]
