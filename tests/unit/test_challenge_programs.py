"""The coding challenge as a candidate hands it in, in three languages: right at an interview, no further.

Each file has its own `main` and its own point type, and one absolute epsilon for everything.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from native import need

from judge.judging import Session, Terms
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.run.result import Mode

pytestmark = pytest.mark.slow

CHALLENGE = Path(__file__).parents[1] / "fixtures" / "challenge"
PROGRAMS = ("CircleSegment.java", "segment.go", "segment.py")


def judged(name: str, level: str | None = None):
    if not name.endswith(".py"):
        need(name.rpartition(".")[2])
    with Session(find_problem("segment"), Terms(timed=False, diagnosed=False, level=level)) as session:
        return session.judge((CHALLENGE / name).read_bytes(), name)


@pytest.mark.parametrize("name", PROGRAMS)
def test_its_function_is_accepted_at_the_interview_level(name):
    text = (CHALLENGE / name).read_text(encoding="utf-8")
    assert " main(" in text
    result = judged(name, "interview")
    assert (result.verdict, result.mode) == (Verdict.AC, Mode.FUNCTION), result.failure
    assert len(result.groups) == len(find_problem("segment").of_level(KataLevel.INTERVIEW))


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_is_rejected_in_production_and_its_epsilon_named(name):
    result = judged(name)
    assert (result.verdict, result.mode) == (Verdict.WA, Mode.FUNCTION)
    interview = {group.name for group in find_problem("segment").of_level(KataLevel.INTERVIEW)}
    rejected = {group.name for group in result.groups if group.verdict is not Verdict.AC}
    assert len(rejected) >= 10
    assert rejected.isdisjoint(interview)
    assert result.pitfall is not None
    assert result.pitfall.names == ("absolute-epsilon",)


def test_all_three_answer_alike():
    wrong = [{group.name: set(group.wrong) for group in judged(name).groups} for name in PROGRAMS]
    assert wrong[0] == wrong[1] == wrong[2]
