"""What exact answers, their intervals and their comparison cost.

    python tests/benchmarks/bench_exact.py

Times are the best of several rounds, each also as a ratio to a yardstick measured in the same rounds: the
plain integer formula of the discriminant, r²a − k², written out for a case of the same size. Read the ratios.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any

from judge.exact import Surd
from judge.geometry import Line, whole
from judge.problem.declare import InvalidCase
from judge.values import check, show
from judge.values.answers import Tolerance
from judge.values.grammar import parse

ROUNDS = 7
CASES = 400
TOLERANCE = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
POINTS, COUNT = parse("points"), parse("count")


def formula(case: Sequence[Any]) -> int:
    """The yardstick: the sign of the discriminant in plain integers, nothing checked."""
    cx, cy, r, (ax, ay), (bx, by) = case
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) - (delta < 0) + 1


def segment_answer(case: Sequence[Any]) -> Any:
    """The reference of the segment problem."""
    line = Line.through(*case)
    return [line.real_point(which) for which in line.within()]


def segment_case(case: Sequence[Any]) -> Any:
    """The whole answer of a case, with all its acceptance intervals."""
    return check.target(POINTS, segment_answer(case), TOLERANCE)


def count_case(case: Sequence[Any]) -> Any:
    """The whole answer of an exact-count case."""
    return check.target(COUNT, whole.count_line(*case), TOLERANCE)


def draw(source: random.Random, size: int, as_float: bool) -> tuple[Any, ...]:
    """One case of coordinates up to `size`."""
    numbers: list[Any] = [source.randint(-size, size) for _ in range(7)]
    if as_float:
        numbers = [source.uniform(-size, size) for _ in numbers]
    cx, cy, r, ax, ay, bx, by = numbers
    return cx, cy, abs(r), (ax, ay), (bx, by)


def two_points(source: random.Random, as_float: bool) -> list[tuple[Any, ...]]:
    """Cases whose segment meets the circle twice, the dearest ones."""
    cases: list[tuple[Any, ...]] = []
    while len(cases) < CASES:
        case = draw(source, 10**9, as_float)
        with suppress(InvalidCase):
            if len(Line.through(*case).within()) == 2:
                cases.append(case)
    return cases


def spent(work: Callable[[Any], object], items: Sequence[Any]) -> float:
    """Microseconds an item, once."""
    start = time.perf_counter()
    for item in items:
        work(item)
    return (time.perf_counter() - start) / len(items) * 1e6


def main() -> None:
    """Print the table."""
    source = random.Random(1)
    ints, floats = two_points(source, False), two_points(source, True)
    large = [draw(source, 10**100, False) for _ in range(CASES)]
    answers = [segment_answer(case) for case in floats]
    targets = [segment_case(case) for case in floats]
    given = [[[number[2] for number in point] for point in target] for target in targets]
    near = [[[number * (1 + 3e-16) for number in point] for point in answer] for answer in given]
    lines = [show.line(POINTS, target) for target in targets]
    surds = [answer[0][0].x for answer in answers]

    def never() -> Any:
        raise AssertionError("a double needs no exact answer")

    def judge(pair: Any) -> object:
        return check.check(POINTS, pair[0], pair[1], never)

    rows: list[tuple[str, Callable[[Any], object], Sequence[Any], Sequence[Any], int]] = [
        ("segment, floats to 1e9: answer and intervals", segment_case, floats, ints, 1),
        ("segment, ints to 1e9: answer and intervals", segment_case, ints, ints, 1),
        (
            "  of which the intervals of 4 numbers",
            lambda a: check.target(POINTS, a, TOLERANCE),
            answers,
            ints,
            1,
        ),
        (
            "decisions of a segment case",
            lambda c: Line.through(*c).within(),
            floats,
            ints,
            1,
        ),
        ("exact-count at 1e100: answer", count_case, large, large, 1),
        ("one correctly rounded double", float, surds, ints, 1),
        ("one directed rounding", Surd.round_up, surds, ints, 1),
        ("check a number, correctly rounded", judge, list(zip(given, targets, strict=True)), ints, 4),
        ("check a number, some ulps off", judge, list(zip(near, targets, strict=True)), ints, 4),
        (
            "check a number of text",
            lambda pair: check.check_line(POINTS, pair[0], pair[1], never),
            list(zip(lines, targets, strict=True)),
            ints,
            4,
        ),
    ]
    print(f"{'':46} {'µs':>8} {'× formula':>10}")
    for name, work, items, yardstick_cases, share in rows:
        pairs = [(spent(work, items) / share, spent(formula, yardstick_cases)) for _ in range(ROUNDS)]
        own, yardstick = min(pair[0] for pair in pairs), min(pair[1] for pair in pairs)
        print(f"{name:46} {own:8.2f} {own / yardstick:10.2f}")


if __name__ == "__main__":
    main()
