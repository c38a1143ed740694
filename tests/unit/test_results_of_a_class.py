"""What is made of a class's results: read back from what is published, JUnit, archives for Dolos."""

from __future__ import annotations

import msgspec
import pytest
from classes import ROWS, row
from msgspec.structs import replace
from past_runs import past_result

from judge.batch.results import advice_of, results_of
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.problem.verdict import Verdict
from judge.run.execute import judge_fault
from judge.run.published import result_of
from judge.run.result import Against, LevelResult, Pitfall, Timing

FULL = replace(
    past_result(failed=("band",), ratio=2.0),
    levels=(LevelResult(KataLevel.INTERVIEW, 3, 3, 2),),
    pitfall=Pitfall(("a", "b"), 0.5, ("", ""), ("c",), (("x", "y"),)),
    time=Timing(0.1, 0.2, None, True, None, 0.5, Against("C++", "why")),
    counterexample={"input": {"r": 10**30}, "expected": "1", "got": "2", "replay": "x"},
)


@pytest.mark.parametrize("result", [FULL, judge_fault("count", "a.py", "why")])
def test_what_is_published_is_read_back(result):
    plain = msgspec.json.decode(msgspec.json.encode(result.as_json()))
    points = {group.name: group.points for group in result.groups}
    read = result_of(plain | {"thresholds": []}, points)  # which older judges wrote
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
