"""The two levels of a kata: counting them, and what is said and kept of them."""

from __future__ import annotations

import pytest
from msgspec.structs import replace
from past_runs import StoppedClock, past_result

from judge.errors import UsageError
from judge.kata.history import History
from judge.kata.levels import level_standings
from judge.problem.choose import chosen_groups
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.report.levels import levels_text
from judge.report.results import verdict_lines
from judge.run import LevelResult

INTERVIEW, PRODUCTION = KataLevel


def levels(interview, production):
    """Both levels as (groups, run, accepted)."""
    return LevelResult(INTERVIEW, *interview), LevelResult(PRODUCTION, *production)


def words(lines):
    return "\n".join("".join(span.text for span in line) for line in lines)


def test_a_problem_without_levels_has_one_only():
    problem = find_problem("count")
    plain = replace(problem, groups=tuple(replace(group, level=None) for group in problem.groups))
    assert plain.levels == ()
    assert chosen_groups(plain, ()) == plain.groups
    with pytest.raises(UsageError, match="there is no level 'intervew'; use one of interview, production"):
        chosen_groups(problem, (), "intervew")
    with pytest.raises(UsageError, match="count has one level only; leave the level out"):
        chosen_groups(plain, (), "interview")


@pytest.mark.parametrize(
    ("interview", "production", "told"),
    [
        ((8, 8, 8), (36, 36, 22), "interview level passed; production level: 22 of 36 groups"),
        ((8, 8, 8), (36, 3, 2), "interview level passed; production level: 2 of 36 groups, 3 judged"),
        ((8, 8, 7), (1, 1, 1), "production level passed; interview level: 7 of 8 groups"),
        ((8, 8, 8), (36, 36, 36), ""),  # accepted says it
        ((8, 1, 1), (36, 0, 0), ""),  # some of its groups are not the level
    ],
)
def test_the_level_that_was_passed_comes_first(interview, production, told):
    found = levels(interview, production)
    assert levels_text(found) == told
    result = replace(past_result(failed=("tiny",)), levels=found)
    line = words(verdict_lines(result, None))
    assert line.startswith(f"WA  {told}; wrong answer, " if told else "WA  wrong answer, ")


def kept(path, *results):
    """The runs of these results, a day after another."""
    clock = StoppedClock()
    with History.open(path, clock=clock) as history:
        for result in results:
            history.add(result, b"", "/mine.py")
            clock.forward(days=1)
        return history.runs()


def names(problem, level):
    return tuple(group.name for group in problem.of_level(level))


def test_a_level_is_passed_when_one_run_passes_all_its_groups(own_history):
    problem = find_problem("count")
    interview, production = names(problem, INTERVIEW), names(problem, PRODUCTION)
    runs = kept(
        own_history,
        past_result("count", passed=interview[:5]),
        past_result("count", passed=interview[5:]),  # two halves are no whole
        past_result("count", passed=(*interview, *production[:3]), failed=production[3:]),
        past_result("count", passed=interview[:2]),
        past_result("segment", passed=interview),
    )
    first, second = level_standings([problem], runs)
    assert (first.level, first.groups, first.best) == (INTERVIEW, len(interview), len(interview))
    assert first.since == runs[2].when
    assert (second.level, second.groups, second.best, second.since) == (PRODUCTION, len(production), 3, None)
    assert [each.best for each in level_standings([problem], runs[:2])] == [5, 0]
