"""`judge progress` after weeks of runs, which are kept here, not judged: skills, what is due, the page."""

from __future__ import annotations

import json
import shutil
from datetime import UTC, datetime, timedelta

import pytest
from cli_support import ROOT
from msgspec.structs import replace

from judge.practice import events
from judge.practice.history import History, run_of
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.result import GroupResult, Pitfall, Result, earned

pytestmark = pytest.mark.slow

START = datetime(2026, 3, 1, 9, tzinfo=UTC)
SET = 'title = "Means"\nabout = "The middle of two numbers."\n'
SKILL = """
[[skills]]
name = "no floor"
about = "Half of an odd number is no integer."
"""


@pytest.fixture
def own_pack(pack, tmp_path, monkeypatch):
    """The tests' pack with a set and a skill that its problem brings."""
    folder = tmp_path / "pack" / "problems"
    shutil.copytree(pack, tmp_path / "pack")
    (folder / "sets").mkdir()
    (folder / "sets" / "means.toml").write_text(SET)
    (folder / "skills.toml").write_text(SKILL)
    text = (folder / "middle" / "problem.toml").read_text()
    (folder / "middle" / "problem.toml").write_text(f'sets = ["means"]\n{text}')
    page = folder / "middle" / "problem.py"
    page.write_text(page.read_text().replace("points=50", 'points=50, skills="no floor"'))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(folder))
    return folder


def passed(*problems, without=(), mistake=None, when=None):
    """Keep a run of each problem that passed the whole but for these groups."""
    verdict = Verdict.WA if without else Verdict.AC
    pitfall = Pitfall((mistake,), 0.9, ("",)) if mistake else None
    with History() as history:
        for problem in problems:
            groups = tuple(
                GroupResult(
                    name=each.name,
                    verdict=Verdict.WA if each.name in without else Verdict.AC,
                    cases=9,
                    passed=9,
                    points=each.points,
                )
                for each in find_problem(problem).groups
            )
            source = b"%d" % len(history.runs())
            result = Result(
                problem=problem, submission="a.py", verdict=verdict, pitfall=pitfall, **earned(groups)
            )
            history.keep(replace(run_of(result, source, "/a.py"), when=when or datetime.now(UTC)), source)


# -- what was learned -------------------------------------------------------------------------------------


def test_on_day_one_there_is_a_bar_for_each_set_and_the_next_skill(judge):
    shown = judge("progress")
    bars = [row.split()[0] for row in shown.lines if "[.........." in row]
    assert bars[1:] == ["first-steps", "junior", "middle", "senior", "professional"]
    following = "judge start distance-squared  The distance squared"
    assert f"  next    {following}" in shown.lines
    assert len(shown.lines) < 24
    assert "Ready?" not in shown.out


def test_the_shipped_solutions_are_nobodys_progress(judge):
    solution = next((ROOT / "solutions" / "which-side" / "accepted").glob("*.py"))
    assert judge("run", "-q", "which-side", solution).status == 0
    assert json.loads(judge("progress", "--json").out)["set"]["solved"] == []
    assert "which-side" in judge("history").out


def test_what_was_learned(judge, own_pack):
    assert judge("progress", "means").lines[1].endswith("0 of 1 kata")
    passed("middle", without=("half",), mistake="floor-division", when=START)
    assert "  open      no floor" in judge("progress", "means").lines
    passed("middle", when=START + timedelta(days=1))
    shown = judge("progress", "means")
    assert shown.lines[1].endswith("1 of 1 kata")
    assert "  shown     no floor" in shown.lines
    assert "  solved    middle" in shown.lines
    assert "  mistakes  floor-division" in shown.lines
    (skill,) = json.loads(judge("progress", "means", "--json").out)["skills"]
    assert (skill["state"], skill["since"]) == ("shown", "2026-03-02T09:00:00Z")
    assert skill["needs"][0]["groups"] == ["half"]
    passed("middle", without=("half",))
    assert "no floor: fails middle half" in judge("progress", "means").out


# -- what is due ------------------------------------------------------------------------------------------


def due(judge):
    """The katas of `judge progress --due`, by where they stand."""
    found = json.loads(judge("progress", "--due", "--json").out)
    rows = {"now": [each["problem"] for each in found["now"]]}
    return rows | {when: [each["name"] for each in found[when]] for when in ("due", "later")}


def test_what_is_due(judge, monkeypatch):
    monkeypatch.setattr(events, "now", lambda: START)
    passed("middle", when=START)
    assert judge("progress", "--due").lines[0] == "Nothing is due today."
    monkeypatch.setattr(events, "now", lambda: START + timedelta(days=3, hours=1))
    shown = judge("progress", "--due")
    assert shown.lines[0].split()[:2] == ["kata", "due"]
    assert shown.lines[1].split()[:2] == ["middle", "today"]
    assert "2026-03-01: solved at once, so again after 3 days" in shown.lines[1]
    assert shown.lines[3].startswith("judge start middle --reset")
    assert "again" in judge("progress").out
    assert due(judge) == {"now": [], "due": ["middle"], "later": []}


def test_a_kata_that_is_not_solved_stands_under_now_and_is_not_repeated(judge, monkeypatch):
    passed("count", without=("band", "grid"), when=START)
    for later in (timedelta(minutes=10), timedelta(days=2)):
        monkeypatch.setattr(events, "now", lambda later=later: START + later)
        assert due(judge) == {"now": ["count"], "due": [], "later": []}
        said = judge("progress", "--due").lines[1].split(maxsplit=2)
        assert said == ["count", "now", "2026-03-01: 96 of 100 points"]
        assert any(row.split()[:2] == ["now", "count"] for row in judge("progress").lines)
    passed("count", when=START + timedelta(days=2))
    assert due(judge) == {"now": [], "due": [], "later": ["count"]}
