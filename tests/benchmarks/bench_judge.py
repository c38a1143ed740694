"""The judge's four figures, as ratios within one run: python tests/benchmarks/bench_judge.py [ROUNDS]

    help     `judge --help`, against a bare interpreter start
    run      `judge run` of an accepted function with a warm cache, against a bare interpreter start
    folder   each further accepted submission of a folder, in CPU time of everything, against a bare start's
    answers  10,000 exact-count answers at 10^100, compiled for comparing, against the plain integer formula

What is compared is measured in turn, round by round, and the median of the rounds' ratios is shown with the
range of their middle half. Two bare starts are shown: with `site` as any command starts, and without it.
"""

from __future__ import annotations

import os
import random
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from judge.problem import Tolerance  # noqa: E402
from judge.problem.find import find_problem  # noqa: E402
from judge.problem.module import load_module  # noqa: E402
from judge.values import check  # noqa: E402

ROUNDS = 15
CASES = 10_000
SIZE = 10**100
FURTHER = 10  # submissions of a folder

BARE = (sys.executable, "-c", "pass")
BAREST = (sys.executable, "-I", "-S", "-c", "pass")
JUDGE = (sys.executable, "-c", "from judge.cli import main; main()")


def ratios(figures: dict[str, Callable[[], None]], bases: dict[str, Callable[[], None]], rounds: int) -> None:
    """Measure everything in turn and print each figure against each base."""
    works = {**bases, **figures}
    times: dict[str, list[float]] = {name: [] for name in works}
    for work in works.values():  # warm caches
        work()
    for _ in range(rounds):
        for name, work in works.items():
            begun = time.perf_counter()
            work()
            times[name].append(time.perf_counter() - begun)
    for figure in figures:
        for base in bases:
            each = sorted(a / b for a, b in zip(times[figure], times[base], strict=True))
            low, high = each[len(each) // 4], each[-1 - len(each) // 4]
            median, absolute = statistics.median(each), statistics.median(times[figure])
            spread = f"{low:.1f} to {high:.1f}"
            print(f"{figure:<28} {median:6.1f} × {base:<30} {spread:>14}   {absolute * 1e3:7.1f} ms")


def process(command: tuple[str, ...], cache: str) -> Callable[[], None]:
    """Running a command to its end, its output into a pipe."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "JUDGE_CACHE": cache}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # compiled modules are part of a warm start

    def work() -> None:
        subprocess.run(command, stdout=subprocess.PIPE, check=True, env=environment)

    return work


def starts(cache: str, rounds: int) -> None:
    """The two figures of starting: help, and a warm run of an accepted function on each problem."""
    figures = {"judge --help": process((*JUDGE, "--help"), cache)}
    for name in ("count", "segment", "ray-nearest", "exact-count"):
        problem = find_problem(name)
        accepted = sorted((problem.solutions / "accepted").glob("*.py"))
        solution = next(path for path in accepted if f"def {problem.entry}(" in path.read_text())
        geometric = problem.solutions / "accepted" / "tolerant.py"
        chosen = geometric if geometric.exists() else solution
        figures[f"judge run {name}"] = process((*JUDGE, "run", name, str(chosen)), cache)
    bases = {"a bare start": process(BARE, cache), "a bare start, -I -S": process(BAREST, cache)}
    ratios(figures, bases, rounds)


def cpu_of(command: tuple[str, ...], cache: str) -> float:
    """CPU seconds of a command and of all that it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process(command, cache)()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def folder(cache: str, rounds: int) -> None:
    """The figure of a folder: what `FURTHER` more copies of an accepted solution cost, each."""
    problem = find_problem("segment")
    source = (problem.solutions / "accepted" / "tolerant.py").read_bytes()
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as many:
        for place, count in ((one, 1), (many, 1 + FURTHER)):
            for number in range(count):
                Path(place, f"{number}.py").write_bytes(source)
        words = (*JUDGE, "run", "-q", "--no-history", "segment")
        each, ratio = [], []
        for _ in range(rounds):
            less, more = cpu_of((*words, one), cache), cpu_of((*words, many), cache)
            bare = min(cpu_of(BAREST, cache) for _ in range(5))
            each.append((more - less) / FURTHER)
            ratio.append(each[-1] / bare)
    shown = f"{statistics.median(ratio):6.1f} × a bare start, -I -S"
    print(f"{'each further submission':<28} {shown:<41} {'':>6}   {statistics.median(each) * 1e3:7.1f} ms")


def large_cases() -> Iterator[tuple[int, int, int, tuple[int, int], tuple[int, int]]]:
    """Circles and lines in integers of about 10^100."""
    draw = random.Random(2)
    for _ in range(CASES):
        cx, cy, ax, ay, bx, by = (draw.randint(-SIZE, SIZE) for _ in range(6))
        yield cx, cy, draw.randint(0, SIZE), (ax, ay), (bx, by)


def answers(rounds: int) -> None:
    """The third figure: building exact-count's answers as its data are built."""
    cases = list(large_cases())
    problem = find_problem("exact-count")
    solve = load_module(problem).solve
    tolerance = Tolerance()

    def build() -> None:
        for case in cases:
            check.target(problem.answer, solve(*case)[0], tolerance)

    def formula() -> None:
        for cx, cy, r, (ax, ay), (bx, by) in cases:
            dx, dy = bx - ax, by - ay
            k = dx * (ay - cy) - dy * (ax - cx)
            _ = r * r * (dx * dx + dy * dy) - k * k

    ratios({"exact-count answers": build}, {"the plain integer formula": formula}, rounds)


def main() -> None:
    """All figures."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else ROUNDS
    with tempfile.TemporaryDirectory() as cache:
        starts(cache, rounds)
        folder(cache, rounds)
    answers(rounds)


if __name__ == "__main__":
    main()
