"""A tiny problem with hand-made data, for tests of judging: is x + y of the point 0, 1 or 2?"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from judge.data import GroupData, ProblemData
from judge.problem.model import Group, GroupLimits, Parameter, Problem, Tier
from judge.run.execute import judge_submission
from judge.values.answers import Words
from judge.values.grammar import parse

LIMITS = GroupLimits(cpu_seconds=2.0, wall_seconds=10.0, memory_mb=256, output_mb=1)
CASES = [(1, (0, 0)), (0, (0.5, 0.5)), (2, (-1, 1)), (0, (0, 0))]
COUNTS = [1, 1, 2, 0]
GOOD = b"def answer(n, P):\n    return int(n + P[0] + P[1])\n"


WORDS = Words(answer="t", meant="0, 1, 2 or none")


def make_group(name="one", points=100):
    return Group(name=name, about="", count=len(CASES), points=points, seed=1)


def make_problem(groups, answer="count", limits=LIMITS):
    low, high = Fraction(-10), Fraction(10)
    parameters = (
        Parameter("n", parse("number"), "", low, high, Fraction(0)),
        Parameter("P", parse("point"), "", low, high, Fraction(0)),
    )
    folder = Path("/nowhere")
    return Problem(
        id="sum",
        title="Sum",
        tier=Tier.JUNIOR,
        summary="",
        entry="answer",
        answer=parse(answer, words=WORDS),
        parameters=parameters,
        limits=limits,
        groups=groups,
        folder=folder,
        solutions=folder,
    )


def make_data(*names, limits=LIMITS, cases=CASES, counts=COUNTS, step=0):
    """Groups of the same cases, but that n and the count grow by `step` from each group to the next."""
    groups = tuple(make_group(name, 100 // len(names)) for name in names)
    problem = make_problem(groups, limits=limits)
    return ProblemData(
        problem,
        tuple(
            GroupData(
                group,
                [(n + place * step, P) for n, P in cases],
                [count + place * step for count in counts],
            )
            for place, group in enumerate(groups)
        ),
    )


def make_parameter_data(values):
    """One case for each v, wanted within v ± 1."""
    group = make_group()
    problem = make_problem((group,), "parameter")
    targets = [(v - 1.0, v + 1.0, v) for v in values]
    return ProblemData(problem, (GroupData(group, [(v, (0, 0)) for v in values], targets),))


def judged(source, data=None, **options):
    data = data or make_data("one")
    source = source.encode() if isinstance(source, str) else source
    return judge_submission(data, source, "my.py", **options).result
