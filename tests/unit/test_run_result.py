"""Results as values and as the published JSON."""

from __future__ import annotations

import json

from judge.problem import Verdict
from judge.run import Failure, GroupResult, Mode, Ratio, Result, Timing, exit_code, judge_fault

GROUPS = (
    GroupResult("easy", Verdict.AC, 60, 60, 1.5, 0.25, 40),
    GroupResult("tangent", Verdict.WA, 60, 51, 3.1, 0.5, 60),
)
FAILURE = Failure(
    "two points wanted, 1 given", "tangent", 17, {"cx": 0, "A": [1, 2.5]}, "[]", "[(1, 2)]", ulps=3.0
)
RESULT = Result(
    "segment", "my.py", Mode.FUNCTION, Verdict.WA, GROUPS, FAILURE, Timing(0.75, 1.0), 2**24, "full"
)


def test_the_published_object():
    assert json.loads(json.dumps(RESULT.as_json())) == {
        "schema": 1,
        "problem": "segment",
        "submission": "my.py",
        "mode": "function",
        "verdict": "WA",
        "score": 40,
        "groups": [
            {
                "name": "easy",
                "verdict": "AC",
                "cases": 60,
                "passed": 60,
                "worst_ulps": 1.5,
                "cpu_seconds": 0.25,
            },
            {
                "name": "tangent",
                "verdict": "WA",
                "cases": 60,
                "passed": 51,
                "worst_ulps": 3.1,
                "cpu_seconds": 0.5,
            },
        ],
        "failure": {
            "group": "tangent",
            "case": 17,
            "input": {"cx": 0, "A": [1, 2.5]},
            "expected": "[]",
            "got": "[(1, 2)]",
            "message": "two points wanted, 1 given",
        },
        "counterexample": None,
        "pitfall": None,
        "thresholds": [],
        "time": {"cpu_seconds": 0.75, "wall_seconds": 1.0, "ratio": None, "borderline": False},
        "memory_bytes": 2**24,
        "isolation": "full",
    }


def test_a_ratio_in_json():
    timing = Timing(1.0, 2.0, Ratio(1.3, 1.2, 1.4, 9), True)
    assert timing.as_json()["ratio"] == {"median": 1.3, "low": 1.2, "high": 1.4, "pairs": 9}


def test_a_fault_of_the_judge_is_a_result_too():
    fault = judge_fault("segment", "my.py", "problem.toml:3: no such key")
    assert (fault.verdict, int(fault.exit_code), fault.score) == (Verdict.JE, 3, 0)
    assert fault.as_json()["failure"]["message"] == "problem.toml:3: no such key"
    assert fault.as_json()["failure"]["group"] is None


def test_exit_codes_of_several():
    accepted = Result("p", "a.py", Mode.FUNCTION, Verdict.AC)
    assert int(exit_code([])) == 0
    assert int(exit_code([accepted, accepted])) == 0
    assert int(exit_code([accepted, RESULT])) == 1
    assert int(exit_code([RESULT, judge_fault("p", "b.py", "broken"), accepted])) == 3
