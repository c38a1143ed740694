"""Programs by other people, in fixtures/programs: the level they pass, and the name of their mistake.

textbook    passes the interview level of its kata, and only that
everyday    makes the mistake that its file is called after, or is called right
changed     is a right program with one edit, called after the mistake
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sampling import daily

from judge import RunOptions, Session
from judge.data.build import validate
from judge.diagnose.candidates import measure
from judge.problem import Verdict
from judge.problem.find import find_problem, sound_problems
from judge.problem.model import KataLevel
from judge.problem.module import load_module

pytestmark = pytest.mark.slow

PROGRAMS = Path(__file__).parents[1] / "fixtures" / "programs"
TEXTBOOK = sorted(path.parent.name for path in PROGRAMS.glob("textbook/*/*.py"))
# Not all of their mistakes are named: their lines are told, or nothing is.
_UNNAMED = (
    "changed/count/forgotten-abs-and-swapped-answers.py",
    "changed/enter-exit/own-extent.py",
    "changed/error-bound/relative-to-result.py",
    "changed/ray-nearest/distance-for-parameter-and-origin-on-circle.py",
    "changed/segment/none-for-empty-and-open-interval.py",
    "everyday/count/absolute-epsilon.py",
    "everyday/segment/inside-ends.py",
)
NAMED = [
    str(path.relative_to(PROGRAMS))
    for kind in ("changed", "everyday")
    for path in sorted(PROGRAMS.glob(f"{kind}/*/*.py"))
]


def judged(path, **terms):
    problem = find_problem(path.parent.name)
    with Session(problem, RunOptions(timed=False, **terms)) as session:
        return problem, session.judge(path.read_bytes(), path.name)


@pytest.fixture(autouse=True)
def _cache(built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))


def test_every_kata_of_two_levels_has_a_textbooks_program():
    levelled = {problem.id for problem in sound_problems()[0] if any(group.level for group in problem.groups)}
    assert levelled == set(TEXTBOOK)


@pytest.mark.parametrize("kata", daily(sorted(set(TEXTBOOK)), ["count", "reflect"]))
def test_a_textbooks_program_passes_the_interview_level_only(kata):
    for path in (PROGRAMS / "textbook" / kata).glob("*.py"):
        problem, result = judged(path, diagnosed=False, named=False)
        assert [level.level for level in result.levels if level.passed] == [KataLevel.INTERVIEW]
        failing = [group.name for group in result.groups if group.verdict is not Verdict.AC]
        assert failing
        assert {problem.group(name).level for name in failing} == {KataLevel.PRODUCTION}


@pytest.mark.parametrize("name", daily(NAMED, NAMED[1::27]))
def test_a_mistake_is_named_and_its_smallest_case_is_a_valid_and_simpler_one(name, request):
    if name in _UNNAMED:
        request.applymarker(pytest.mark.xfail(reason="not all of its mistakes are named", strict=True))
    stem = re.sub(r"-\d$", "", Path(name).stem)
    problem, result = judged(PROGRAMS / name)
    if stem == "right":
        assert result.verdict is Verdict.AC
        return
    said = list(result.pitfall.names) if result.pitfall and result.pitfall.names else ["silent"]
    assert sorted(said) == sorted(stem.split("-and-"))
    module = load_module(problem)
    case, first = (
        tuple(as_case(each) for each in found.input.values())
        for found in (result.counterexample, result.failure)
    )
    validate(problem, module, case)
    assert measure(case) <= measure(first)


def as_case(value):
    """A case's value from its JSON."""
    return tuple(map(as_case, value)) if isinstance(value, list) else value
