"""What deciding an answer costs, beside the code of another commit.

    python tests/benchmarks/bench_values.py [COMMIT]

Lists of points and ints are decided by this checkout's types and by those of COMMIT, in turn, in one process;
each figure is the median of the rounds' ratios. Without COMMIT it is the last one whose judge had kinds of
answers, in `judge/compare`. More complex types stand beside the list of two points.
"""

from __future__ import annotations

import importlib
import io
import random
import statistics
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from judge.exact import Surd  # noqa: E402
from judge.values import Real, Run, Tolerance, parse, vector  # noqa: E402

ROUNDS = 41
CASES = 2_000
TOLERANCE = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
Decide = Callable[[Any, Any], object]


def last_with_kinds() -> str:
    """The parent of the commit that removed `judge/compare`."""
    command = ["git", "log", "-1", "--diff-filter=D", "--format=%H^", "--", "judge/compare/check.py"]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()


def package_of(commit: str, folder: str) -> None:
    """Lay the commit's package down in `folder`, under the name `judge_before`."""
    command = ["git", "archive", commit, "judge"]
    content = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        archive.extractall(folder, filter="data")
    package = Path(folder) / "judge"
    for path in package.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        text = text.replace("from judge", "from judge_before").replace("import judge", "import judge_before")
        path.write_text(text, encoding="utf-8")
    package.rename(Path(folder) / "judge_before")
    sys.path.insert(0, folder)


def never() -> Any:
    """No double asks for the exact answer."""
    raise AssertionError("a double needs no exact answer")


def before(kind: str) -> tuple[Decide, ModuleType]:
    """How the other commit decides, with the module of its targets."""
    check = importlib.import_module("judge_before.compare.check").check
    member = importlib.import_module("judge_before.problem").AnswerKind(kind)
    return lambda raw, target: check(member, raw, target, never), importlib.import_module(
        "judge_before.compare.targets"
    )


def now(text: str) -> Decide:
    """How this checkout decides."""
    check = parse(text).check
    return lambda raw, target: check(raw, target, never)


def seconds(decide: Decide, pairs: list[tuple[Any, Any]]) -> float:
    """The CPU time of one round."""
    begun = time.thread_time()
    for raw, target in pairs:
        decide(raw, target)
    return time.thread_time() - begun


def compared(name: str, ours: tuple[Decide, list[Any]], theirs: tuple[Decide, list[Any]]) -> None:
    """Print the median ratio of the two over interleaved rounds, and its quartiles."""
    ratios, own = [], []
    for number in range(ROUNDS):
        first, second = (ours, theirs) if number % 2 else (theirs, ours)
        times = {id(first): seconds(*first), id(second): seconds(*second)}
        ratios.append(times[id(ours)] / times[id(theirs)])
        own.append(times[id(ours)])
    ratios.sort()
    quartiles = f"{ratios[len(ratios) // 4]:.2f} to {ratios[-1 - len(ratios) // 4]:.2f}"
    each = statistics.median(own) / len(ours[1]) * 1e9
    print(f"{name:44} {statistics.median(ratios):6.2f}   {quartiles:>14}   {each:8.0f} ns")


def points(count: int) -> Iterator[list[tuple[Real, ...]]]:
    """Exact lists of irrational points."""
    source = random.Random(5)
    while True:
        yield [
            vector([Surd(source.randint(-(10**9), 10**9), 3, source.randint(2, 10**9), 7) for _ in "xy"], 1)
            for _ in range(count)
        ]


def nearest(target: Any) -> Any:
    """The answer of correctly rounded doubles."""
    return [[number[2] for number in point] for point in target]


def main() -> None:
    """Print the table."""
    commit = sys.argv[1] if len(sys.argv) > 1 else last_with_kinds()
    with tempfile.TemporaryDirectory() as folder:
        package_of(commit, folder)
        print(f"{'deciding':44} {'ratio':>6}   {'quartiles':>14}   {'now':>11}")
        type_ = parse("[vec2; 0..2]")
        for count in (2, 1, 0):
            made = points(count)
            targets = [type_.target(next(made), TOLERANCE) for _ in range(CASES)]
            given = [nearest(target) for target in targets]
            decide, classes = before("points")
            old = [classes.PointsTarget(target) for target in targets]
            ours = now("[vec2; 0..2]"), list(zip(given, targets, strict=True))
            theirs = decide, list(zip(given, old, strict=True))
            compared(f"a list of {count} points, before", ours, theirs)
            if count == 2:
                base = ours
        source = random.Random(7)
        counts = [source.choice((0, 1, 2, None)) for _ in range(CASES)]
        decide, classes = before("count")
        old = [classes.CountTarget(count) for count in counts]
        ours = now("int?"), list(zip(counts, counts, strict=True))
        compared("an int or None, before", ours, (decide, list(zip(counts, old, strict=True))))
        decide, classes = before("parameter")
        real = parse("real?")
        targets = [real.target(next(points(1))[0][0], TOLERANCE) for _ in range(CASES)]
        given = [target[2] for target in targets]
        old = [classes.ParameterTarget(target) for target in targets]
        ours = now("real?"), list(zip(given, targets, strict=True))
        compared("a real or None, before", ours, (decide, list(zip(given, old, strict=True))))
    hits = parse("[(real, int, word(enter|exit))]")
    for name, wrap in (("in order", list), ("in a run", lambda items: [Run(items)])):
        exact = wrap([(Real(Surd(1), 1), 0, "enter"), (Real(Surd(1), 1), 1, "exit")])
        target = hits.target(exact, TOLERANCE)
        raw = [[1.0, 0, {"word": "enter"}], [1.0, 1, {"word": "exit"}]]
        compared(f"two hits {name}, a list of 2 points", (now(hits.text), [(raw, target)] * CASES), base)


if __name__ == "__main__":
    main()
