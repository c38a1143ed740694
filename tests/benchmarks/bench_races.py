"""How far a ratio is spread where several processes judge: python tests/benchmarks/bench_races.py [RATIOS]

    apart     each of them has locks of its own, so their races run beside the others' judging
    alone     they share them, as they do by themselves: each race is alone

Three processes judge one accepted file at once, again and again, a handful one way and a handful the other.
Shown is the quartile spread of each process's ratios, as a share of their median, and of all together; and in
how many races the machine was busy. On a machine that others use too, only the two compared say something.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from judge.judging.job import Terms  # noqa: E402
from judge.judging.session import Session  # noqa: E402
from judge.problem.find import find_problem  # noqa: E402
from judge.run.alone import VARIABLE  # noqa: E402

PROBLEM, FILE = "segment", "geometric.py"
PROCESSES = 3
RATIOS = 30  # of each process, each way
AT_ONCE = 5
WAYS = ("apart", "alone")


def serve() -> None:
    """Judge as many times as each line says, with the locks that it names; answer with the ratios."""
    problem = find_problem(PROBLEM)
    source = (problem.solutions / "accepted" / FILE).read_bytes()
    with Session(problem, Terms(diagnosed=False, named=False)) as session:
        session.judge(source, FILE)  # the data and the boxes are ready
        for line in sys.stdin:
            locks, count = json.loads(line)
            os.environ[VARIABLE] = locks
            found = [session.judge(source, FILE).time.ratio for _ in range(count)]
            print(json.dumps([[each.median, each.busy] for each in found if each]), flush=True)


def spread(values: Sequence[float]) -> float:
    """The distance of the quartiles as a share of the median."""
    low, median, high = statistics.quantiles(values, n=4)
    return (high - low) / median


def main(ratios: int) -> None:
    """Run the processes, one handful each way in turn, and show what came of it."""
    found: dict[str, list[list[Any]]] = {way: [[] for _ in range(PROCESSES)] for way in WAYS}
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="judge-races-")))
        command = [sys.executable, __file__, "--serve"]
        pipe = subprocess.PIPE
        judges = [
            stack.enter_context(subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True))
            for _ in range(PROCESSES)
        ]
        for _ in range(-(-ratios // AT_ONCE)):
            for way in WAYS:
                for place, judge in enumerate(judges):
                    locks = folder / (str(place) if way == "apart" else "shared")
                    assert judge.stdin
                    judge.stdin.write(json.dumps([str(locks), AT_ONCE]) + "\n")
                    judge.stdin.flush()
                for place, judge in enumerate(judges):
                    assert judge.stdout
                    found[way][place] += json.loads(judge.stdout.readline())
        for judge in judges:
            assert judge.stdin
            judge.stdin.close()
    for way in WAYS:
        every = [each for one in found[way] for each in one]
        each = " ".join(f"{spread([ratio for ratio, _ in one]):.3f}" for one in found[way])
        whole = spread([ratio for ratio, _ in every])
        busy = sum(bool(said) for _, said in every)
        print(f"{way}: quartile spread {each}, together {whole:.3f}; busy in {busy} of {len(every)} races")


if __name__ == "__main__":
    if sys.argv[1:] == ["--serve"]:
        serve()
    else:
        main(int(sys.argv[1]) if sys.argv[1:] else RATIOS)
