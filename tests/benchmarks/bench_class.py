"""What `judge class` costs beside `judge run`, and whether both say the same.

    python tests/benchmarks/bench_class.py [SUBMISSIONS]

A class is made of the known solutions and mistakes of four problems, each text with a comment of its own so
that none is judged once for two. CPU seconds are those of the command and of the processes that it waited
for, with a warm cache; read the ratio. The engine is what a task costs that does nothing: given, taken back
and kept.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from itertools import islice
from pathlib import Path
from typing import Any

import msgspec

from judge.batch.model import Done, Handin, Row, Task
from judge.batch.store import Store
from judge.judging.processes import Processes
from judge.mistakes.family import Family
from judge.problem.find import find_problem

PROBLEMS = ("count", "segment", "ray-nearest", "exact-count")
JOBS = "2"
NO_OPS = 2000
COMPARED = ("verdict", "score", "failure", "pitfall")


def texts(problem: str, count: int) -> list[bytes]:
    """So many different programs: accepted ones, files of mistakes, and mistakes as choices make them."""
    found = find_problem(problem)
    files = [
        path.read_bytes() for kind in ("accepted", "wrong") for path in found.solutions.glob(f"{kind}/*.py")
    ]
    family = Family(found)
    made = [family.program(choice).encode() for choice, _ in family.named]
    step = max(1, len(made) // max(1, count - len(files)))
    every = [*files, *made[::step], *files, *made]
    return [text + f"\n# {at}\n".encode() for at, text in enumerate(islice(every, count))]


def make_class(folder: Path, count: int) -> None:
    """A folder for each student, a file for each problem."""
    for problem in PROBLEMS:
        for at, text in enumerate(texts(problem, count // len(PROBLEMS))):
            student = folder / f"student{at:03}"
            student.mkdir(parents=True, exist_ok=True)
            (student / f"{problem}.py").write_bytes(text)


def used(*words: str, folder: Path) -> tuple[float, list[dict[str, Any]]]:
    """The CPU seconds of a command, and the objects that it writes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run(
        [sys.executable, "-m", "judge", *words], cwd=folder, stdout=subprocess.PIPE, check=False
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, [json.loads(line) for line in ended.stdout.splitlines()]


def no_op(task: Task) -> str:
    """A task that does nothing."""
    return msgspec.json.encode(Done({"verdict": "AC", "submission": task.name})).decode()


def engine(folder: Path) -> float:
    """CPU milliseconds for a task that does nothing, its row kept."""
    handins = [Handin(f"s{at}", "p", f"s{at}/p.py", b"pass\n") for at in range(NO_OPS)]
    tasks = [Task("p", each.file, each.source, "{}", "{}") for each in handins]

    def spent() -> float:
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.process_time() + children.ru_utime + children.ru_stime

    began = spent()
    with Store.open(folder / "no-op.sqlite3") as store:
        for place, text in Processes(int(JOBS)).finished(no_op, tasks, lambda task, why: why):
            each = handins[place]
            store.keep(
                Row(str(place), each.student, "p", each.file, "d", "AC", 100, 100, "", "", "", 0.0, "", text)
            )
        assert len(store.rows()) == NO_OPS
    return 1000 * (spent() - began) / NO_OPS


def main() -> None:
    """Print the figures."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        os.environ.setdefault("JUDGE_CACHE", str(folder / "cache"))
        make_class(folder / "class", count)
        files = {
            name: sorted(
                str(path.relative_to(folder / "class")) for path in folder.glob(f"class/*/{name}.py")
            )
            for name in PROBLEMS
        }
        for name in PROBLEMS:  # so that the cache is warm for both
            used("run", name, files[name][-1], "--json", "--no-history", folder=folder / "class")
        plain, run = 0.0, {}
        for name in PROBLEMS:
            words = ("--json", "--no-history", "--no-shrink", "-j", JOBS)
            seconds, found = used("run", name, *files[name], *words, folder=folder / "class")
            plain += seconds
            run |= {each["submission"]: each for each in found}
        whole, rows = used("class", "class", "--json", "-j", JOBS, folder=folder)
        alike = 0
        for row in rows:
            one, other = row["result"], run[row["file"]]
            groups = [[{**group, "cpu_seconds": 0} for group in each["groups"]] for each in (one, other)]
            same = groups[0] == groups[1] and all(one[key] == other[key] for key in COMPARED)
            alike += same
            if not same:
                print("differs:", row["file"], one["verdict"], other["verdict"])
        print(f"{alike} of {len(run)} the same verdict, score, groups, failing case and mistake")
        print(f"CPU: judge run {plain:.1f} s, judge class {whole:.1f} s, ratio {whole / plain:.2f}")
        print(f"engine: {engine(folder):.2f} ms of CPU a task")


if __name__ == "__main__":
    main()
