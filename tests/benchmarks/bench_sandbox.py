"""What containment costs, as ratios taken in the same run: python tests/benchmarks/bench_sandbox.py."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time

from judge.sandbox import Limits, open_box

LIMITS = Limits(cpu_seconds=30.0, wall_seconds=60.0, memory_bytes=512 << 20, output_bytes=64 << 20)
ROUNDS = 9
SOURCE = b"""def f(cx, cy, r, A, B):
    return [(cx + A[0] * 0.5, cy + A[1] * 0.5), (cx - A[0] * 0.5, cy - A[1] * 0.5)]
"""
CALLS = [(i * 0.1, 2.0, 3, (i * 0.3, 5), (7.0, i)) for i in range(10_000)]


def seconds(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def ratio(work, yardstick):
    """The median over interleaved rounds of how many times the yardstick `work` takes."""
    return statistics.median(seconds(work) / seconds(yardstick) for _ in range(ROUNDS))


def interpreter():
    subprocess.run([sys.executable, "-I", "-c", "pass"], check=True)


def open_and_call_once():
    with open_box(SOURCE, "bench.py") as box:
        box.inspect()
        box.call_many("f", CALLS[:1], LIMITS)


def plain_loop(function):
    for arguments in CALLS:
        function(*arguments)


def main():
    print(
        f"open, inspect, one call, close: {ratio(open_and_call_once, interpreter):.2f} x a bare interpreter"
    )
    with open_box(b"print(len(input()))", "bench.py") as box:
        program = ratio(lambda: box.run_program(b"x\n", LIMITS), interpreter)
    print(f"one program: {program:.2f} x a bare interpreter")
    namespace = {}
    exec(SOURCE, namespace)
    function = namespace["f"]
    with open_box(SOURCE, "bench.py") as box:
        box.inspect()
        above = statistics.median(
            seconds(lambda: box.call_many("f", CALLS, LIMITS))
            - seconds(lambda: [function(*c) for c in CALLS])
            for _ in range(ROUNDS)
        )
    print(f"10,000 calls: {above / len(CALLS) * 1e6:.1f} us a call above a plain loop of them")


if __name__ == "__main__":
    main()
