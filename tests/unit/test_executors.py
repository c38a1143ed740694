"""What every executor holds to: kill a worker, lose nothing.

An executor joins with a context manager in PLACES, which opens one of two or three workers. What these do is
in tests/executed.py, which their processes must be able to import.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import contextmanager, nullcontext
from pathlib import Path
from types import ModuleType

import pytest
from executed import work
from sampling import nightly

from judge.errors import ShortageError, UsageError
from judge.judging import pool
from judge.judging.pool import ATTEMPTS, Here, Processes, in_order

pytestmark = pytest.mark.slow

TESTS = Path(__file__).parents[1]


def opened(executor):
    return lambda: nullcontext(executor)


@contextmanager
def on_a_cluster():
    pytest.importorskip("distributed", reason="distributed is not installed")
    from clusters import served

    from judge.batch.cluster import ClusterExecutor

    with (
        tempfile.TemporaryDirectory() as folder,
        served(Path(folder), 3) as cluster,
        ClusterExecutor(str(cluster.file)) as elsewhere,
    ):
        yield elsewhere


PLACES = {"here": opened(Here()), "processes": opened(Processes(2)), "cluster": on_a_cluster}


@pytest.fixture(scope="module", params=["here", "processes", nightly("cluster")])
def place(request):
    return request.param


@pytest.fixture(scope="module")
def executor(place):
    with PLACES[place]() as opened:
        yield opened


@pytest.fixture(autouse=True)
def _own_process(monkeypatch):
    monkeypatch.setenv("EXECUTED_BY", str(os.getpid()))
    monkeypatch.setitem(sys.modules, "__main__", ModuleType("__main__"))  # workers need not import pytest


def lost(item, why):
    return f"lost {item.split()[-1]}: {why}"


def items(folder, *whats):
    return [f"{folder} {what} n{place}" for place, what in enumerate(whats)]


def test_each_item_once_with_its_place(executor, place, tmp_path):
    first = "well" if place == "here" else "held"
    given = items(tmp_path, first, *["well"] * 5)
    found = []
    for each in executor.run(work, given, lost):
        found.append(each)
        (tmp_path / "release").touch()  # what the first item waits for, unless it is done here
    assert sorted(found) == [(at, f"N{at}") for at in range(6)]
    assert (found[0][0] == 0) == (place == "here")
    assert list(executor.run(work, [], lost)) == []


def test_killed_workers_lose_nothing(executor, tmp_path):
    # No other item kills: an item dies by itself only once, and by its neighbour, and is alone then.
    given = items(tmp_path, "well", "once", "well", "faulty", "once", "well")
    found = dict(executor.run(work, given, lost))
    assert sorted(found) == list(range(6))
    assert [found[at] for at in (0, 1, 2, 4, 5)] == ["N0", "N1", "N2", "N4", "N5"]
    assert found[3] == f"lost n3: it was lost {ATTEMPTS} times: internal fault: ArithmeticError('n3')"


def test_what_kills_every_worker_costs_itself_alone(executor, place, tmp_path):
    found = dict(executor.run(work, items(tmp_path, "well", "always", "well", "well"), lost))
    assert [found.pop(at) for at in (0, 2, 3)] == ["N0", "N2", "N3"]
    (told,) = found.values()
    assert told.startswith("lost n1: ")
    assert f" {ATTEMPTS} times" in told
    assert place != "cluster" or told == "lost n1: the machine died 3 times"
    tried = sum(each.name.startswith("n1.") for each in tmp_path.iterdir())  # by its process
    assert place != "processes" or tried == 3


def test_results_come_in_order_and_what_the_caller_has_done_wrong_ends_the_work(executor, tmp_path):
    found = list(in_order(executor, work, items(tmp_path, *["well"] * 5), lost))
    assert found == [f"N{at}" for at in range(5)]
    with pytest.raises(UsageError, match="cannot be had here"):  # on a cluster it costs every worker
        list(in_order(executor, work, items(tmp_path, "usage", "well"), lost))


def test_who_takes_the_last_result_and_no_more_leaves_no_worker_behind(tmp_path):
    before = set(threading.enumerate())
    found = Processes(1).run(work, items(tmp_path, "well"), lost)
    assert next(found) == (0, "N0")
    found.close()
    assert set(threading.enumerate()) == before  # a pool that still ends can fail where the interpreter does
    assert multiprocessing.active_children() == []


def test_ctrl_c_waits_while_a_worker_is_started(tmp_path, monkeypatch):
    started, start = [], pool.SpawnProcess.start

    def interrupted(process):
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)  # no other thread of a test's may take it
        start(process)
        started.append(process.pid)

    monkeypatch.setattr(pool.SpawnProcess, "start", interrupted)
    with pytest.raises(KeyboardInterrupt):
        list(Processes(1).run(work, items(tmp_path, "well"), lost))
    assert len(started) == 1
    assert multiprocessing.active_children() == []


_PARENT = """
import sys
from executed import work
from judge.judging.pool import Processes

if __name__ == "__main__":
    given = [f"{sys.argv[1]} {what} n{at}" for at, what in enumerate(["well", "forever", "forever"])]
    for found in Processes(2).run(work, given, lambda item, why: why):
        print(found, flush=True)
"""


@contextmanager
def parent(folder):
    """A process whose two workers are in the middle of an item each, and their process ids."""
    script = folder / "parent.py"
    script.write_text(_PARENT)
    done = folder / "done"
    done.mkdir()
    command = [sys.executable, str(script), str(done)]
    found = subprocess.Popen(
        command,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (TESTS, TESTS.parent)))},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    try:
        began = waited(lambda: [*done.glob("n1.*"), *done.glob("n2.*")], 2)
        yield found, {int(path.suffix[1:]) for path in began}
    finally:
        found.kill()
        found.communicate()


def waited(look, count):
    """What `look` finds, once it is so much; looked for as long as a busy machine may need."""
    for _ in range(6000):
        found = look()
        if len(found) == count:
            return found
        time.sleep(0.01)
    raise AssertionError(f"{count} looked for, {len(found)} found")


def living(pids):
    """Those that are there, and no longer wait to be reaped."""
    found = []
    for pid in pids:
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            continue
        found += [pid] if state not in "ZX" else []
    return found


@pytest.mark.parametrize("how", ["Ctrl-C", "SIGKILL"])
def test_workers_end_with_who_gave_them_work(how, tmp_path):
    with parent(tmp_path) as (process, pids):
        assert len(pids) == 2
        if how == "Ctrl-C":
            os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        else:
            process.kill()
        printed, said = process.communicate(timeout=60)
        waited(lambda: living(pids), 0)
    assert printed == b"(0, 'N0')\n"
    own = 1 if how == "Ctrl-C" else 0  # traceback, of the script itself
    assert (said.count(b"Traceback"), said.count(b"KeyboardInterrupt\n")) == (own, own)


def test_where_no_process_can_be_started_that_is_one_line(tmp_path, monkeypatch):
    def full(_process):
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(pool.SpawnProcess, "start", full)
    with pytest.raises(ShortageError, match="no further process"):
        list(Processes(2).run(work, items(tmp_path, "well", "well"), lost))
