"""How often the time limit judges wrongly: python tests/benchmarks/bench_limits.py [RUNS]

Submissions that take 0.9, 0.95, 1.05 and 1.1 of the limit are raced against the reference, full isolation
included, while the other cores are kept busy. For comparison, the same runs are judged by a fixed limit in
seconds, calibrated at the start. A row is the share of wrong verdicts.
"""

from __future__ import annotations

import multiprocessing
import os
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from judge.run.timing import race
from judge.sandbox import Box, Limits, open_box

RUNS = 40
LIMIT = 5.0  # times the reference
ROUNDS = 4_000  # of the reference's loop: about 1 ms a call
CALLS = 10
LIMITS = Limits(cpu_seconds=20.0, wall_seconds=60.0, memory_bytes=256 << 20, output_bytes=1 << 20)
SOURCE = """
def work(n):
    total = 0
    for number in range({rounds}):
        total += number * number % 7
    return total
"""
FACTORS = (0.9, 0.95, 1.05, 1.1)


def cpu_of(box: Box) -> float | None:
    """The CPU seconds of one turn."""
    return box.call("work", [(n,) for n in range(CALLS)], LIMITS).usage.cpu_seconds


def busy(seconds: float) -> None:
    """Keep a core busy in bursts, as a person's other programs do."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        burst = time.monotonic() + 0.05
        while time.monotonic() < burst:
            sum(range(1000))
        time.sleep(0.02)


def main(runs: int) -> None:
    """Judge each factor so many times; print the shares of wrong verdicts."""
    others = [
        multiprocessing.Process(target=busy, args=(600,), daemon=True)
        for _ in range((os.cpu_count() or 2) - 1)
    ]
    for other in others:
        other.start()
    with open_box(SOURCE.format(rounds=ROUNDS).encode(), "reference.py") as reference:
        fixed = LIMIT * statistics.median(cpu_of(reference) or 0.0 for _ in range(15))
        print(f"{'of the limit':<14}{'wrong by ratio':>16}{'wrong by seconds':>18}{'borderline':>12}")
        for factor in FACTORS:
            source = SOURCE.format(rounds=round(ROUNDS * LIMIT * factor)).encode()
            by_ratio = by_seconds = borderline = 0
            with open_box(source, "submission.py") as box:
                for _ in range(runs):
                    decision = race(lambda box=box: cpu_of(box), lambda: cpu_of(reference), LIMIT)
                    by_ratio += decision.too_slow != (factor > 1)
                    borderline += decision.borderline
                    by_seconds += ((cpu_of(box) or 0.0) > fixed) != (factor > 1)
            print(f"{factor:<14}{by_ratio / runs:>16.1%}{by_seconds / runs:>18.1%}{borderline / runs:>12.1%}")
    for other in others:
        other.terminate()


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else RUNS)
