"""Results read back from what is published, and the JUnit file of a class."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

import msgspec
import pytest
from classes import ROWS, row
from msgspec.structs import replace
from page_support import outcome
from past_runs import past_result

from judge.batch.results import advice_of, batch_junit, results_of
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.problem.verdict import Verdict
from judge.run import exit_code
from judge.run.execute import judge_fault
from judge.run.published import result_of
from judge.run.result import Against, LevelResult, Pitfall, Timing
from judge.run.thresholds import Flip, Law, Threshold

THRESHOLD = Threshold("tangency", 1e-9, 1e-6, (Flip({"r": 2.0}, 1e-9, None),), Law({"r": 1}, 1e-9), "loose")
FULL = replace(
    outcome(mistake="absolute-epsilon", ratio=2.0),
    thresholds=(THRESHOLD,),
    levels=(LevelResult(KataLevel.INTERVIEW, 3, 3, 2),),
    pitfall=Pitfall(("a", "b"), 0.5, ("", ""), ("c",), (("x", "y"),)),
    time=Timing(0.1, 0.2, None, True, None, 0.5, Against("C++", "why")),
    counterexample={"input": {"r": 10**30}, "expected": "1", "got": "2", "replay": "x"},
)


@pytest.mark.parametrize(
    "result",
    [
        FULL,
        past_result(failed=("band",), ratio=1.5),
        outcome(verdict=Verdict.AC),
        judge_fault("count", "a.py", "why"),
    ],
)
def test_what_is_published_is_read_back(result):
    plain = msgspec.json.decode(msgspec.json.encode(result.as_json()))
    points = {group.name: group.points for group in result.groups}
    read = result_of(plain, points)
    assert read.as_json() == result.as_json()
    assert read.failure == (replace(result.failure, given=None) if result.failure else None)


def test_rows_get_points_and_advice():
    count = find_problem("count")
    advice = advice_of(count)
    (name, told) = next(iter(advice.items()))
    (result,) = results_of([row("ann", "count", name, ("tangent",))], {"count": count})
    assert result.submission == "ann/count.py"
    assert result.pitfall.advice == (told,)
    assert result.score == sum(each.points for each in count.groups if each.name in ("examples", "grid"))
    (other,) = results_of([row("ann", "gone", "some", ("tangent",))], {})
    assert (other.verdict, other.pitfall.name) == (Verdict.WA, "some")


def test_a_row_that_cannot_be_read_is_a_fault_of_its_own():
    broken = replace(ROWS[0], json='{"result": {"verdict": "??"}}')
    (result,) = results_of([broken], {})
    assert (result.verdict, result.submission) == (Verdict.JE, "ann/count-1.py")


def test_exit_codes_of_several():
    accepted, wrong, fault = outcome(verdict=Verdict.AC), outcome(), judge_fault("count", "b.py", "broken")
    found = [exit_code(each) for each in ([], [accepted] * 2, [accepted, wrong], [wrong, fault, accepted])]
    assert [int(each) for each in found] == [0, 0, 1, 3]


def test_a_suite_for_each_hand_in():
    root = Xml.fromstring(batch_junit(ROWS, {"count": find_problem("count")}))
    suites = root.findall("testsuite")
    assert [suite.get("name") for suite in suites][:2] == ["count ann/count-1.py", "count ann/count-2.py"]
    assert len(suites) == len(ROWS)
    assert root.get("failures") == str(sum(int(suite.get("failures")) for suite in suites)) == "10"
    assert suites[6].find("testcase").get("name") == "compile"
