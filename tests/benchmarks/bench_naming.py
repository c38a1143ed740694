"""What the first wrong answer waits for: python tests/benchmarks/bench_naming.py [PROBLEM…]

For each problem the CPU time in which all of its known mistakes are learnt anew, the data being there, in all
and by what it consists of:

    mistakes   those of mistakes.py, computed here
    programs   those of wrong/, judged in containment, here and in the boxes
    kept       what the answers are packed and written in
    a call     the time of one answer of one mistake, against one call of the first right program

The whole is shown against a loop of a million additions too, as a ratio that another machine would have.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
os.environ["JUDGE_CACHE"] = tempfile.mkdtemp()

from judge.data.load import load_data  # noqa: E402
from judge.mistakes.computed import Computer, Program, entry_of  # noqa: E402
from judge.mistakes.known import KnownAnswers  # noqa: E402
from judge.mistakes.makers import read_makers  # noqa: E402
from judge.problem.find import find_problem  # noqa: E402
from judge.run.settings import Settings  # noqa: E402

USUAL = ("segment", "enter-exit", "polygon", "reflect", "sphere", "csg", "count")


def cpu() -> float:
    """Of this process and of all that it waited for, in seconds."""
    both = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return sum(each.ru_utime + each.ru_stime for each in both)


def yardstick() -> float:
    """A million additions."""
    begun, total = time.process_time(), 0
    for each in range(1_000_000):
        total += each
    return time.process_time() - begun


def called(name: str) -> tuple[float, int]:
    """The time that the first accepted function takes for all cases, and how many these are."""
    problem = find_problem(name)
    data = load_data(problem)
    source = next(
        path.read_bytes()
        for path in sorted((problem.solutions / "accepted").glob("*.py"))
        if f"def {problem.entry}(".encode() in path.read_bytes()
    )
    function = entry_of(problem, Program(source, "accepted"))
    calls = [given for each in data.groups if each.group.size is None for given in problem.calls(each.cases)]
    begun = time.process_time()
    for given in calls:
        function(*given)
    return time.process_time() - begun, len(calls)


def main(names: tuple[str, ...]) -> None:
    """A line for each problem."""
    heads = ("all", 6), ("mistakes", 9), ("kept", 6), ("programs", 9), ("a call", 8), ("additions", 10)
    print(f"{'problem':<16} {' '.join(f'{head:>{width}}' for head, width in heads)}")
    for name in names:
        problem = find_problem(name)
        data = load_data(problem)
        programs = [each.program for each in read_makers(problem).all]
        trusted = [each for each in programs if each.trusted]
        once, cases = called(name)
        begun = time.process_time()
        computer = Computer(data)
        for each in trusted:
            computer.behaviour(each)
        computed = time.process_time() - begun
        start = cpu()
        KnownAnswers(data, None, Settings(measured=False)).of(programs)
        whole = cpu() - start
        start = cpu()
        KnownAnswers(data, 1, Settings(measured=False)).of([each for each in programs if not each.trusted])
        files = cpu() - start
        counts = f"{len(trusted)} mistakes, {len(programs) - len(trusted)} programs, {cases} cases"
        ratio = computed / max(1, len(trusted)) / once
        rest = max(0.0, whole - computed - files)
        print(
            f"{name:<16} {whole:5.1f}s {computed:8.1f}s {rest:5.1f}s {files:8.1f}s {ratio:7.1f}× "
            f"{whole / yardstick():9.0f}×   {counts}",
            flush=True,
        )


if __name__ == "__main__":
    main(tuple(sys.argv[1:]) or USUAL)
