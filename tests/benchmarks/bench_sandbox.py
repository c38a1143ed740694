"""What containment costs, as ratios to plain Python measured in the same run: `python
tests/benchmarks/bench_sandbox.py`.

    program    one process per test through the fork server against one bare `python -I -S` per test
    function   a call through the container against the same call in a plain loop, in microseconds above it
    accuracy   CPU time as seen from outside against what the loop itself measures
    limit      by how much a 100 ms CPU limit is passed

Rounds are interleaved and medians taken; on a busy machine read the ratios, not the times.
"""

from __future__ import annotations

import argparse
import os
import random
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from judge.sandbox import open_box
from judge.sandbox.available import levels_here
from judge.sandbox.boundary import Limits
from judge.sandbox.box import PythonBox

LIMITS = Limits(cpu_seconds=20.0, wall_seconds=60.0, memory_bytes=256 << 20, output_bytes=16 << 20)
PROGRAM = b"""
import sys
def main():
    rows = sys.stdin.read().split("\\n")
    for row in rows[1:int(rows[0]) + 1]:
        cx, cy, r, ax, ay, bx, by = map(int, row.split())
        dx, dy = bx - ax, by - ay
        s = dx * (cy - ay) - dy * (cx - ax)
        d = r * r * (dx * dx + dy * dy) - s * s
        print("none" if not dx and not dy else 0 if d < 0 else 1 if d == 0 else 2)
main()
"""
FUNCTION = """
def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    s = dx * (cy - A[1]) - dy * (cx - A[0])
    d = r * r * (dx * dx + dy * dy) - s * s
    return 0 if d < 0 else 1 if d == 0 else 2
"""
WORK = """
import time
COUNT = 0
def work(count):
    began = time.process_time()
    total = 0
    for number in range(count):
        total += number * number % 7
    return time.process_time() - began
"""


def bare_spawn(stdin: bytes, python: str) -> None:
    subprocess.run(
        [python, "-I", "-S", "-c", PROGRAM.decode()], input=stdin, stdout=subprocess.DEVNULL, check=True
    )


def timed(action: Callable[[], object]) -> float:
    began = time.perf_counter()
    action()
    return time.perf_counter() - began


def program_mode(level: str, rounds: int) -> None:
    numbers = random.Random(1)
    stdin = ("1\n" + " ".join(str(numbers.randint(0, 99)) for _ in range(7))).encode()
    python = os.path.realpath(sys.executable)
    with open_box(PROGRAM, "program.py", level=level) as box:
        box.run_program(stdin, LIMITS)
        pairs = [
            (timed(lambda: bare_spawn(stdin, python)), timed(lambda: box.run_program(stdin, LIMITS)))
            for _ in range(rounds)
        ]
    bare, ours = (statistics.median(column) for column in zip(*pairs, strict=True))
    ratio = statistics.median(mine / theirs for theirs, mine in pairs)
    times = f"bare {bare * 1e3:6.2f} ms   contained {ours * 1e3:6.2f} ms"
    print(f"{level:7} program   {times}   ratio {ratio:.2f} (≤ 0.25)")


def function_mode(level: str, rounds: int) -> None:
    numbers = random.Random(2)
    calls = []
    for _ in range(10_000):
        cx, cy, r, ax, ay, bx, by = (numbers.randint(-999, 999) for _ in range(7))
        calls.append((cx, cy, abs(r), (ax, ay), (bx, by)))
    scope: dict[str, Callable[..., int]] = {}
    exec(FUNCTION, scope)
    plain = scope["line_count"]
    pairs = []
    with open_box(FUNCTION.encode(), "function.py", level=level) as box:
        box.call("line_count", calls[:10], LIMITS)
        for _ in range(rounds):
            loop = timed(lambda: [plain(*arguments) for arguments in calls])
            pairs.append((loop, timed(lambda: box.call("line_count", calls, LIMITS))))
    loop, ours = (statistics.median(column) / len(calls) * 1e6 for column in zip(*pairs, strict=True))
    above = statistics.median(mine - theirs for theirs, mine in pairs) / len(calls) * 1e6
    print(f"{level:7} function  loop {loop:6.2f} µs   contained {ours:6.2f} µs   above {above:.2f} µs (≤ 5)")


def accuracy(level: str, rounds: int) -> None:
    with open_box(WORK.encode(), "work.py", level=level) as box:
        per_second = 200_000 / _said(box, 200_000)[0]
        for name, seconds in (("1 ms", 0.001), ("50 ms", 0.05)):
            pairs = [_said(box, round(per_second * seconds)) for _ in range(rounds)]
            errors = [outside / inside - 1 for inside, outside in pairs]
            print(
                f"{level:7} accuracy  {name:>5}   outside/inside {1 + statistics.median(errors):.3f}"
                f"   from {1 + min(errors):.3f} to {1 + max(errors):.3f} (0.9 to 1.1)"
            )


def _said(box: PythonBox, count: int) -> tuple[float, float]:
    result = box.call("work", [[count]], LIMITS)
    return float(result.replies[0].answer), result.usage.cpu_seconds


def limit(level: str, rounds: int) -> None:
    tight = Limits(0.1, 20.0, LIMITS.memory_bytes, LIMITS.output_bytes)
    with open_box(b"while True: pass", "loop.py", level=level) as box:
        spent = [box.run_program(b"", tight).usage.cpu_seconds for _ in range(rounds)]
    middle, worst = statistics.median(spent) * 1e3, max(spent) * 1e3
    print(f"{level:7} limit     100 ms enforced at {middle:.1f} ms, worst {worst:.1f} (≤ 110)")


def start(level: str, rounds: int) -> None:
    python = os.path.realpath(sys.executable)
    pairs = []
    for _ in range(rounds):
        bare = timed(lambda: subprocess.run([python, "-I", "-S", "-c", ""], check=True))
        pairs.append((bare, timed(lambda: open_box(b"", "empty.py", level=level).__exit__())))
    bare, ours = (statistics.median(column) * 1e3 for column in zip(*pairs, strict=True))
    print(f"{level:7} start     bare interpreter {bare:.1f} ms   container up and down {ours:.1f} ms")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--level", action="append", help="only this level")
    chosen = parser.parse_args()
    for level in levels_here():
        if not level.available:
            print(f"{level.name:7} cannot be had here: {level.why_not}")
        elif not chosen.level or level.name in chosen.level:
            start(level.name, chosen.rounds)
            program_mode(level.name, 3 * chosen.rounds)
            function_mode(level.name, chosen.rounds)
            accuracy(level.name, chosen.rounds)
            limit(level.name, max(3, chosen.rounds // 3))


if __name__ == "__main__":
    main()
