"""A textbook's programs pass the interview level of our katas, and fail the production level by name."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.judging import Session, Terms
from judge.problem import Verdict
from judge.problem.find import all_problems, find_problem
from judge.problem.level import KataLevel

TEXTBOOK = Path(__file__).parents[1] / "fixtures" / "textbook"
PROGRAMS = sorted(f"{path.parent.name}/{path.name}" for path in TEXTBOOK.glob("*/*.py"))
NAMED = {  # what the judge says of each; None where eight cases are too few for a name
    "adaptive/discriminant.py": "float-sign",
    "beams/one_turn.py": "wrap-around-lost",
    "chord/half_chord.py": "absolute-epsilon",
    "circle-circle/radical_line.py": "absolute-epsilon",
    "common-tangents/normals.py": "absolute-epsilon",
    "count/discriminant.py": "absolute-epsilon",
    "count/distance.py": "absolute-epsilon",
    "csg/intervals.py": "absolute-epsilon",
    "distance/cross_product.py": "normal-form-global",
    "enter-exit/quadratic.py": "absolute-epsilon",
    "error-bound/relative.py": "ignores-cancellation",
    "exact-count/discriminant.py": "float-arithmetic",
    "exact-segment/quadratic.py": "float-roots",
    "foot/projection.py": "absolute-epsilon",
    "line-points/foot.py": "absolute-epsilon",
    "nearest/centres.py": "centre-cell-only",
    "normal-form/perpendicular.py": "absolute-epsilon",
    "normal/quadratic.py": "absolute-epsilon",
    "on-circle/distance.py": "absolute-epsilon",
    "polygon/quadratic.py": "absolute-epsilon",
    "ray-nearest/quadratic.py": "absolute-epsilon",
    "reflect/quadratic.py": "absolute-epsilon",
    "segment/quadratic.py": "absolute-epsilon",
    "shadow/shadow_ray.py": "absolute-t-min",
    "silhouette/hysteresis.py": "absolute-epsilon",
    "sphere/quadratic.py": "absolute-epsilon",
    "stable-roots/stable.py": "rounded-discriminant",
    "swept-balls/quadratic.py": "absolute-epsilon",
    "swept-wall/sides_and_caps.py": "absolute-epsilon",
    "tangents/polar.py": "absolute-epsilon",
    "test-writer/by_kind.py": None,
    "vector/fixed.py": "absolute-epsilon",
}


def test_every_kata_of_two_levels_has_such_a_program():
    assert sorted(NAMED) == PROGRAMS
    levelled = {each.id for each in all_problems() if any(group.level for group in each.groups)}
    assert {name.split("/")[0] for name in PROGRAMS} == levelled


@pytest.mark.slow
@pytest.mark.parametrize("program", PROGRAMS)
def test_it_passes_the_interview_and_fails_production_by_name(program):
    problem = find_problem(program.split("/")[0])
    with Session(problem, Terms(timed=False, diagnosed=False)) as session:
        result = session.judge((TEXTBOOK / program).read_bytes(), program)
    verdicts = {group.name: group.verdict for group in result.groups}
    interview = {group.name for group in problem.of_level(KataLevel.INTERVIEW)}
    assert {name for name in interview if verdicts[name] is not Verdict.AC} == set()
    rejected = [name for name in verdicts if name not in interview and verdicts[name] is not Verdict.AC]
    assert len(rejected) >= (5 if len(problem.groups) > 16 else 2)
    if NAMED[program] is None:
        assert result.pitfall is None
    else:
        assert result.pitfall is not None
        assert NAMED[program] in result.pitfall.names


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest", "exact-count"])
def test_what_an_interview_asks_of_first_is_in_its_level(name):
    problem = find_problem(name)
    interview = {group.name for group in problem.of_level(KataLevel.INTERVIEW)}
    production = {group.name for group in problem.of_level(KataLevel.PRODUCTION)}
    assert interview | production == {group.name for group in problem.groups}
    assert interview >= {"examples", "grid", "tangent", "point-circle", "axis-parallel", "neighbours"}
    assert production & {"tiny", "small", "large", "tangent-edge", "whole", "hairline-huge", "offset"}
    assert len(interview) >= 8
    assert len(production) >= 15
