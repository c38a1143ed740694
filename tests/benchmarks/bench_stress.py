"""The stress figure, problem by problem: python tests/benchmarks/bench_stress.py [SECONDS]

How many cases a second `judge stress` manages in function mode on the problem's `quadratic.py`, with this
process and the box's pinned to one core: building the cases, proving and solving them exactly, calling the
submission, deciding on its answers.

So that a busy or a slow machine shows as such, a fixed loop of pure Python runs before and after each. The
last column is the time of a case as a multiple of the time of one round of that loop.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from judge.data import ProblemData  # noqa: E402
from judge.data.build import Fresh  # noqa: E402
from judge.problem.find import find_problem  # noqa: E402
from judge.problem.module import load_module  # noqa: E402
from judge.run.stress import Stressed, stress  # noqa: E402
from judge.sandbox import open_box  # noqa: E402

SECONDS = 10.0
ROUNDS = 200_000
PROBLEMS = ("count", "segment", "ray-nearest", "exact-count")


def yardstick() -> float:
    """The seconds that one round of a fixed loop takes: a few operations on integers, a tuple, a float."""
    begun = time.perf_counter()
    total, point = 0, (0, 0.0)
    for number in range(ROUNDS):
        total += number * number % 7
        point = (total, point[1] + 0.5)
    return (time.perf_counter() - begun) / ROUNDS


def stressed(name: str, seconds: float) -> Stressed:
    """One problem's stress, from a fixed seed."""
    problem = find_problem(name)
    module = load_module(problem)
    source = (problem.solutions / "accepted" / "quadratic.py").read_bytes()
    fresh = Fresh(problem, module, problem.groups, seed=1)
    with open_box(source, "quadratic.py") as box:
        data = ProblemData(problem, (), loaded=module)
        return stress(data, fresh, box, source, "quadratic.py", seconds=seconds)


def main() -> None:
    """All problems."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else SECONDS
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    head = ("verdict", "cases", "a second", "isolation", "× loop")
    print(f"{'problem':<12}", *(f"{word:>10}" for word in head))
    for name in PROBLEMS:
        before = yardstick()
        found = stressed(name, seconds)
        yard = (before + yardstick()) / 2
        rate = found.cases / found.seconds
        ratio = 1 / rate / yard if rate else 0.0
        result = found.result
        words = (result.verdict.value, f"{found.cases:,}", f"{rate:,.0f}")
        print(f"{name:<12}", *(f"{word:>10}" for word in (*words, result.isolation, f"{ratio:.0f}")))


if __name__ == "__main__":
    main()
