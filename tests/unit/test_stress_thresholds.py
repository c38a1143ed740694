"""A stress measures the submission's own thresholds, as a run does."""

from __future__ import annotations

import json

import pytest
from jsonschema import Draft202012Validator

from judge.judging import Session, Terms
from judge.judging.stressing import Stressing
from judge.problem.find import find_problem
from judge.report.stress import stress_lines
from judge.schema import schema_of

pytestmark = pytest.mark.slow

COUNT = """
from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / length
    if abs(d - r) <= EPS:
        return 1
    return 2 if d < r else 0
"""


def stressed(epsilon, **terms):
    problem = find_problem("count")
    source = COUNT.replace("EPS", epsilon).encode()
    with Session(problem, Terms(named=False, **terms)) as session:
        found = Stressing(source, "mine.py", problem.groups, 7, 1.0).run(session)
    Draft202012Validator(schema_of("stress")).validate(json.loads(json.dumps(found.as_json())))
    return found


@pytest.mark.parametrize(
    ("epsilon", "verdict", "told"),
    [
        ("1e-9", "WA", "for a tangency: 1e-9 at size 1, 4e-3 of it at size 2e-7; it does not grow"),
        ("1e-10 * e", "AC", "for a tangency: 1e-10 of the extent; that is between 1e-12 and 1e-7"),
    ],
)
def test_it_is_told_on_screen_and_in_the_json(epsilon, verdict, told):
    found = stressed(epsilon)
    assert found.result.verdict.value == verdict
    assert found.as_json()["thresholds"][0]["decision"] == "a tangency"
    assert any(
        f"threshold  {told}" in "".join(span.text for span in line) for line in stress_lines(found, None, 60)
    )


def test_without_the_smallest_case_there_is_no_threshold():
    assert stressed("1e-9", diagnosed=False).as_json()["thresholds"] == []
