"""`judge progress` and `judge due` after weeks of runs, which are kept here, not judged."""

from __future__ import annotations

import json
import shutil
from datetime import UTC, datetime, timedelta

import pytest
from cli_support import ROOT
from msgspec.structs import replace

from judge.kata import events
from judge.kata.history import History, run_of
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
    with History.open() as history:
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


# -- judge progress ---------------------------------------------------------------------------------------


def test_the_shipped_solutions_are_nobodys_progress(judge):
    solution = next((ROOT / "solutions" / "which-side" / "accepted").glob("*.py"))
    assert judge("run", "-q", "which-side", solution).status == 0
    assert "0 of 6" in judge("progress").out
    assert "which-side" in judge("history").out


def test_what_was_learned(judge, own_pack):
    assert judge("progress", "means").lines[0] == "Means: 0 of 1 skill"
    passed("middle", without=("half",), mistake="floor-division", when=START)
    assert judge("progress", "means").lines[2].split() == ["open", "no", "floor"]
    passed("middle", when=START + timedelta(days=1))
    shown = judge("progress", "means")
    assert shown.lines[0] == "Means: 1 of 1 skill"
    assert shown.lines[2].split() == ["shown", "no", "floor"]
    assert "1 of 1 solved: middle" in shown.out
    assert "floor-division" in shown.out
    (skill,) = json.loads(judge("progress", "means", "--json").out)["skills"]
    assert (skill["state"], skill["attempts"], skill["since"]) == ("shown", 2, "2026-03-02T09:00:00+00:00")
    assert (skill["mistakes"], skill["needs"][0]["groups"]) == ({"floor-division": 1}, ["half"])
    passed("middle", without=("half",))
    assert "no floor: fails middle half" in judge("progress", "means").out
    assert "Fails middle half." in judge("progress", "means", "--all").out


# -- judge due --------------------------------------------------------------------------------------------


def test_what_is_due(judge, monkeypatch):
    monkeypatch.setattr(events, "now", lambda: START)
    passed("middle", when=START)
    passed("count", without=("band",), when=START)
    shown = judge("due")
    assert shown.lines[0] == "Nothing is due today."
    assert shown.lines[4].split()[:4] == ["count", "in", "1", "day"]
    monkeypatch.setattr(events, "now", lambda: START + timedelta(days=2, hours=1))
    shown = judge("due")
    assert shown.lines[0] == "Today  1 kata"
    assert shown.lines[2].split()[:4] == ["count", "1", "day", "ago"]
    assert "2026-03-01: not solved, so again after 1 day" in shown.lines[2]
    assert "  next  judge init count count_0303.py" in shown.lines
    found = json.loads(judge("due", "--json").out)
    assert [review["problem"] for review in found["due"]] == ["count"]
    assert [review["problem"] for review in found["later"]] == ["middle"]
    assert found["due"][0]["rating"] == "again"
