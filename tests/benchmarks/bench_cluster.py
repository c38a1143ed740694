"""What a cluster costs, and that it loses nothing: run by hand, not collected by pytest.

    python tests/benchmarks/bench_cluster.py
        10,000 jobs that do nothing
    python tests/benchmarks/bench_cluster.py --kills [N]
        N hand-ins of four problems, 200 by default: workers, a machine and the client are killed, and the
        rows are held against those of this machine alone

Costs are CPU time of the client and the scheduler, not wall time: the machine may be busy with other things.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from itertools import cycle, islice
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests"), str(Path(__file__).parent)]

from clusters import HERE, served, workers  # noqa: E402

from judge.cluster.ring import Ring  # noqa: E402
from judge.cluster.where import Address  # noqa: E402

JOBS, FIRST = 10_000, 1_000
PROBLEMS = ("count", "segment", "ray-nearest", "exact-count")
TELLING = ("student", "problem", "file", "verdict", "score", "points", "mistake")
TICKS = os.sysconf("SC_CLK_TCK")


def nothing(item: str) -> str:
    """What a worker does that has nothing to do."""
    return item


def cpu(pid: int) -> float:
    """The CPU seconds of a process and its threads."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def megabytes(pid: int | str) -> float:
    """What a process holds in memory."""
    (line,) = (
        line for line in Path(f"/proc/{pid}/status").read_text().splitlines() if line.startswith("VmRSS")
    )
    return int(line.split()[1]) / 1024


def no_ops() -> None:
    """The cost of the engine alone."""
    from bench_cluster import nothing as work

    with (
        served(HERE, "--scheduler", "-j", "0") as (told, scheduler),
        served(told["address"], "-j", "2", PYTHONPATH=os.pathsep.join(sys.path[:3])),
        Ring(Address.of(told["address"])) as ring,
    ):
        print(f"{'jobs':>8} {'kept':>8} {'client':>10} {'scheduler':>10}   memory of both")
        for count in (FIRST, JOBS):
            before = time.process_time(), cpu(scheduler.pid)
            items = [f"job {number}" for number in range(count)]
            kept = {
                place
                for place, text in ring.finished(work, items, lambda _item, why: why)
                if text == items[place]
            }
            spent = time.process_time() - before[0], cpu(scheduler.pid) - before[1]
            each = [f"{1000 * seconds / count:.2f} ms" for seconds in spent]
            memory = f"{megabytes('self'):.0f} and {megabytes(scheduler.pid):.0f} MB"
            print(f"{count:>8} {len(kept):>8} {each[0]:>10} {each[1]:>10}   {memory}")
            assert len(kept) == count


def class_of(folder: Path, count: int) -> None:
    """A class whose hand-ins are the known solutions, each with a comment of its own."""
    for problem in PROBLEMS:
        known = [
            path
            for kind in ("accepted", "wrong")
            for path in sorted((ROOT / "solutions" / problem / kind).glob("*.py"))
        ]
        for number, path in enumerate(islice(cycle(known), count // len(PROBLEMS))):
            place = folder / f"student{number:03}" / f"{problem}.py"
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(f"{path.read_text()}\n# {number}\n")


def judged(*words: str) -> subprocess.Popen[str]:
    """`judge class WORDS --json`."""
    command = [sys.executable, "-m", "judge", "class", *words, "--json"]
    return subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}
    )


def facts(row: dict) -> list:
    """What may not depend on where a row was judged."""
    result = row["result"]
    groups = [(group["name"], group["passed"]) for group in result["groups"]]
    failure = {**(result["failure"] or {}), "seconds": None}
    return [*(row[name] for name in TELLING), groups, failure]


def kills(count: int) -> None:
    """Workers, a machine and the client are killed in the middle."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place, "homework")
        class_of(folder, count)
        began = time.perf_counter()
        plain = (
            judged(str(folder), "-j", "2", "--out", f"{place}/plain.sqlite3").communicate()[0].splitlines()
        )
        print(f"this machine alone: {len(plain)} rows in {time.perf_counter() - began:.0f} s")
        with served(HERE, "--scheduler", "-j", "0") as (told, _):
            address = told["address"]
            with served(address, "-j", "2") as (_, first), served(address, "-j", "1") as (_, machine):
                client = judged(str(folder), "--on", address)
                seen = [client.stdout.readline() for _ in range(3)]
                os.kill(workers(first)[0], signal.SIGKILL)
                print("a worker is killed after 3 rows")
                seen += [client.stdout.readline() for _ in range(30)]
                machine.kill()
                print("a machine is gone for good after 33 rows")
                seen += [client.stdout.readline() for _ in range(30)]
                client.kill()
                client.communicate()
                print("the client is killed after 63 rows")
                client, rows, killed = judged(str(folder), "--on", address), [], 0
                for line in client.stdout:
                    rows.append(json.loads(line))
                    if len(rows) % max(1, count // 8) == 0 and workers(first):
                        os.kill(random.choice(workers(first)), signal.SIGKILL)
                        killed += 1
                client.wait()
        kept = sum(row["kept"] for row in rows)
        print(f"the same command again: {kept} kept, {len(rows) - kept} judged, {killed} more workers killed")
        alike = {row["file"]: facts(row) for row in map(json.loads, plain)}
        other = {row["file"]: facts(row) for row in rows}
        differ = [name for name in alike if alike[name] != other.get(name)]
        equal = f"{len(alike) - len(differ)} of {len(alike)} equal"
        print(f"{len(rows)} rows, {len(other)} of them different files, {equal}")
        for name in differ:
            print(name, alike[name][3:7], other.get(name, [])[3:7], sep="\n  ")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kills", type=int, nargs="?", const=200, metavar="N")
    asked = parser.parse_args()
    kills(asked.kills) if asked.kills else no_ops()
