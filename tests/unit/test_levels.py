"""The two levels of a kata: counting them, and what is said and kept of them."""

from __future__ import annotations

import json
import zlib
from xml.etree import ElementTree

import pytest
from msgspec.structs import replace
from page_support import check_html, html_of, known, outcome
from past_runs import StoppedClock, past_result

from judge.errors import UsageError
from judge.kata.history import History
from judge.kata.levels import level_standings
from judge.problem import Verdict
from judge.problem.choose import chosen_groups
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.report.history import history_lines
from judge.report.junit import junit
from judge.report.levels import levels_text
from judge.report.results import verdict_lines
from judge.run import GroupResult, LevelResult

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
        ((8, 8, 8), (36, 0, 0), "interview level passed; production level not judged"),
        ((8, 8, 8), (36, 3, 2), "interview level passed; production level: 2 of 36 groups, 3 judged"),
        ((8, 0, 0), (36, 36, 36), "production level passed; interview level not judged"),
        ((8, 8, 7), (1, 1, 1), "production level passed; interview level: 7 of 8 groups"),
        ((8, 8, 8), (36, 36, 36), ""),  # accepted says it
        ((8, 8, 7), (36, 36, 22), ""),
        ((8, 1, 1), (36, 0, 0), ""),  # some of its groups are not the level
    ],
)
def test_the_level_that_was_passed_comes_first(interview, production, told):
    found = levels(interview, production)
    assert levels_text(found) == told
    result = replace(past_result(failed=("tiny",)), levels=found)
    line = words(verdict_lines(result, None))
    assert line.startswith(f"WA  {told}; wrong answer, " if told else "WA  wrong answer, ")


def test_junit_has_both_levels_as_properties():
    result = replace(past_result(failed=("tiny",)), levels=levels((8, 8, 8), (36, 36, 22)))
    root = ElementTree.fromstring(junit([result, past_result()]))
    told = [{each.get("name"): each.get("value") for each in suite.iter("property")} for suite in root]
    assert told[0]["interview_level"] == "passed"
    assert told[0]["production_level"] == "22 of 36 groups"
    assert not {"interview_level", "production_level"} & set(told[1])


def kept(path, *results):
    """The runs of these results, a day after another."""
    clock = StoppedClock()
    with History.open(path, clock=clock) as history:
        for result in results:
            history.add(result, b"", "/mine.py")
            clock.forward(days=1)
        return history.runs()


def test_a_damaged_result_keeps_its_row(own_history):
    passed = replace(past_result(failed=("tiny",)), levels=levels((8, 8, 8), (36, 36, 22)))
    (run,) = kept(own_history, passed)
    assert "interview level passed, tiny" in words(history_lines([run], None))
    for packed in (b"", zlib.compress(json.dumps({"levels": [{"level": "interview"}]}).encode())):
        row = words(history_lines([replace(run, packed=packed)], None))
        assert "tiny" in row
        assert "level" not in row


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


def test_the_report_has_both_levels_and_the_groups_below_them(own_history):
    problem = find_problem("count")
    verdicts = {group.name: Verdict.WA if group.name == "tiny" else Verdict.AC for group in problem.groups}
    groups = tuple(GroupResult(name, verdict, 10, 5, None, 0.0, 1) for name, verdict in verdicts.items())
    done = replace(outcome(), groups=groups)
    html = html_of(kept(own_history, done), known("count"))
    outline = check_html(html)
    text = " ".join(outline.text.split())
    assert "Interview level passed on 1 Mar 2026" in text
    assert f"Production level best {len(names(problem, PRODUCTION)) - 1} of 23 groups" in text
    assert (
        text.index("Interview level passed") < text.index("grid passed") < text.index("Production level best")
    )
    assert text.index("Production level best") < text.index("tiny 5 of 10")
    assert "interview passed" in text  # beside the problem in the table of all
