"""`judge class --on` and `judge worker`: a scheduler and workers on this machine, killed in the middle."""

from __future__ import annotations

import json
import os
import signal
import socket
import ssl
import subprocess
import sys
import time
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT
from executed import work
from jsonschema import Draft202012Validator

pytest.importorskip("distributed")

from clusters import HERE, below, served, workers

from judge.cluster.greeting import Offer
from judge.cluster.keys import new_keys
from judge.cluster.ring import Ring
from judge.cluster.where import Address
from judge.errors import JudgeError, UsageError
from judge.schema import schema_of

pytestmark = pytest.mark.slow

SOURCES = (
    MEAN,
    FLOOR,
    "def middle(a, b):\n    return a / 0\n",
    "def middle(a, b)\n",
    "def middle(a, b):\n    return a / 2 + b / 2\n",
    "def middle(a, b):\n    return b\n",
)
STUDENTS = 18
TELLING = ("student", "problem", "file", "verdict", "score", "points", "mistake")


def lost(item, why):
    return f"lost: {why}"


def facts(row):
    """What may not depend on where a row was judged."""
    result = row["result"]
    groups = [(group["name"], group["passed"]) for group in result["groups"]]
    failure = {**(result["failure"] or {}), "seconds": None}
    return [row[name] for name in TELLING], groups, failure, result["counterexample"]


def rows_of(text):
    return {row["file"]: facts(row) for row in map(json.loads, text.splitlines())}


@pytest.fixture
def homework(tmp_path):
    """Files that all differ."""
    folder = tmp_path / "homework"
    for number in range(STUDENTS):
        place = folder / f"s{number:02}"
        place.mkdir(parents=True)
        (place / "middle.py").write_text(f"{SOURCES[number % len(SOURCES)]}\n# {number}\n")
    return folder


class Client:
    """`judge class` as a process, whose rows are read one by one."""

    def __init__(self, said, *words):
        """`said` is the file that gets what it says to people."""
        command = [sys.executable, "-m", "judge", "class", *map(str, words), "--json"]
        settings = {**os.environ, "PYTHONPATH": str(ROOT)}
        self.said = said
        with said.open("w") as err:
            self.process = subprocess.Popen(
                command, stdout=subprocess.PIPE, stderr=err, text=True, env=settings
            )

    def rows(self, count):
        """So many further rows."""
        return [json.loads(self.process.stdout.readline()) for _ in range(count)]

    def end(self):
        rest = self.process.stdout.read()  # `communicate` would lose what was read ahead of a row
        self.process.stdout.close()
        return self.process.wait(timeout=300), rest, self.said.read_text()

    def kill(self):
        self.process.kill()
        self.end()


def gone(pids):
    for _ in range(600):
        if not any(alive(pid) for pid in pids):
            return True
        time.sleep(0.1)
    return False


def alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def kill_one(process):
    """Kill a worker in the middle of a submission; every process that it had started ends too."""
    for _ in range(2000):
        for pid in workers(process):
            held = [each for each in below(process) if each != pid and ancestor(each, pid)]
            if held:
                os.kill(pid, signal.SIGKILL)
                assert gone([pid, *held])
                return
        time.sleep(0.01)
    raise AssertionError("no worker was seen to judge")


def ancestor(pid, wanted):
    while pid > 1:
        if pid == wanted:
            return True
        try:
            pid = int(Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
        except OSError:
            return False
    return False


def heard_without_a_certificate(address, authority):
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.load_verify_locations(cadata=authority)
    context.check_hostname = False
    with socket.create_connection((address.host, address.port)) as plain:
        try:
            with context.wrap_socket(plain) as talk:
                talk.sendall(bytes(64))
                return talk.recv(1)
        except OSError:
            return b""


def test_killed_workers_and_a_killed_client_lose_nothing(homework, tmp_path, judge):
    plain = rows_of(judge("class", str(homework), "--json", "--out", str(tmp_path / "plain.sqlite3")).out)
    assert len(plain) == STUDENTS
    with served(HERE, "--scheduler", "-j", "3") as (told, process):
        Draft202012Validator(schema_of("worker")).validate(told)
        assert told["workers"] == 3
        assert "limits" not in told["isolation"]
        words = (tmp_path / "said", homework, "--on", told["address"])
        client = Client(*words)
        client.rows(2)
        kill_one(process)
        client.rows(3)
        client.kill()
        client = Client(*words)
        kept = client.rows(5)
        kill_one(process)
        status, rest, said = client.end()
    assert all(row["kept"] for row in kept)
    rows = [*kept, *map(json.loads, rest.splitlines())]
    assert len(rows) == STUDENTS
    assert {row["file"]: facts(row) for row in rows} == plain
    assert status == 1
    assert "kept from before" in said
    assert {row["isolation"] for row in rows if row["verdict"] != "CE"} == {told["isolation"][0]}
    assert gone([process.pid])


def test_certificates_keep_strangers_out_and_a_lost_scheduler_is_a_line(tmp_path, monkeypatch):
    keys = new_keys()
    keys.write(tmp_path / "keys")
    with served("tls://127.0.0.1:0", "--scheduler", "-j", "1", "--keys", str(tmp_path / "keys")) as (
        told,
        process,
    ):
        address = Address.of(told["address"])
        assert told["keys"]
        for stranger in (Ring(address, new_keys()), Ring(Address("tcp", address.host, address.port))):
            with (
                pytest.raises(JudgeError, match=r"does not take this certificate|give tls:// if it has keys"),
                stranger,
            ):
                pass
        assert heard_without_a_certificate(address, keys.ca) == b""
        with Ring(address, keys) as ring:
            monkeypatch.setenv("EXECUTED_BY", str(os.getpid()))
            given = [f"{tmp_path} {what} n{place}" for place, what in enumerate(["well", "forever"])]
            waiting = ring.finished(work, given, lost)
            assert next(waiting) == (0, "N0")
            started = [process.pid, *below(process)]
            process.kill()
            with pytest.raises(
                JudgeError, match="is lost; what is judged is kept, and the same command goes on"
            ):
                next(waiting)
            assert gone(started)
    with (
        pytest.raises(JudgeError, match=r"no scheduler can be reached at .* \(connection refused\)"),
        Ring(address, keys),
    ):
        pass


@pytest.mark.parametrize(
    ("resources", "told"),
    [
        (None, "the scheduler at .* has no workers"),
        ({}, "was not started by 'judge worker'"),
        ({"judge": 1, "judge 0.0.1 (abc)": 1}, r"has judge 0\.0\.1 \(abc\), and here is 9 \(def\)"),
    ],
)
def test_a_cluster_of_others_is_told_before_anything_is_sent(resources, told):
    from distributed import LocalCluster

    started = LocalCluster(
        n_workers=0 if resources is None else 1,
        threads_per_worker=1,
        processes=False,
        protocol="tcp://",
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        worker_dashboard_address="127.0.0.1:0",
        resources=resources or {},
    )
    with started as cluster:
        wanted = Offer({"judge": "9 (def)"}, {}, ())
        ring = Ring(Address.of(cluster.scheduler_address), None, wanted, patience=0.1)
        with pytest.raises(JudgeError, match=told) as fault:
            ring.__enter__()
    assert "\n" not in str(fault.value)


def test_a_worker_of_another_judge_that_comes_later_is_left_out_and_named(tmp_path, monkeypatch):
    from distributed import LocalCluster, Worker

    monkeypatch.setenv("EXECUTED_BY", str(os.getpid()))
    here, there = (Offer({"judge": name}, {}, ("full",)) for name in ("9 (def)", "8 (abc)"))

    async def join(address, offer):
        resources = offer.resources()
        return await Worker(address, nthreads=1, resources=resources, dashboard_address="127.0.0.1:0")

    started = LocalCluster(
        n_workers=0, processes=False, protocol="tcp://", host="127.0.0.1", dashboard_address="127.0.0.1:0"
    )
    with started as cluster:
        workers = [cluster.sync(join, cluster.scheduler_address, here)]
        with Ring(Address.of(cluster.scheduler_address), None, Offer(here.facts, {}, ())) as ring:
            assert (ring.level, ring.left_out()) == ("full", ())
            workers.append(cluster.sync(join, cluster.scheduler_address, there))
            given = [f"{tmp_path} well n{place}" for place in range(5)]
            while not ring.left_out():
                assert len(dict(ring.finished(work, given, lost))) == 5
            assert ring.alive() == 1
            assert sorted(ring.everywhere(work, given, lost)) == [(place, f"N{place}") for place in range(5)]
            (told,) = ring.left_out()
            assert told == f"the worker {workers[1].address} has judge 8 (abc), and here is 9 (def)"
        for worker in workers:
            cluster.sync(worker.close)


def test_plain_class_and_help_import_nothing_of_it(homework, tmp_path):
    script = (
        "import sys\nfrom judge.cli import main\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "heavy = ('dask', 'distributed', 'cryptography', 'asyncio')\n"
        "print([name for name in heavy if name in sys.modules])\n"
    )
    for words in (
        ["class", str(homework), "--problem", "middle", "--shard", "1/18", "-q"],
        ["worker", "--help"],
    ):
        command = [sys.executable, "-c", script, *words]
        settings = {**os.environ, "PYTHONPATH": str(ROOT)}
        ended = subprocess.run(
            command, capture_output=True, text=True, check=True, env=settings, cwd=tmp_path
        )
        assert ended.stdout.splitlines()[-1] == "[]", ended


def test_a_machine_that_would_leave_its_files_open_does_not_work(monkeypatch):
    from judge.cluster import station
    from judge.sandbox.probe import Level

    poor = (
        Level("full", False, "", "bubblewrap is not installed", "apt-get install bubblewrap"),
        Level("strong", False, "", "the kernel has no landlock", ""),
        Level("limits", True, ""),
    )
    monkeypatch.setattr(station, "levels", lambda _hide: poor)
    with pytest.raises(UsageError, match="only isolation 'limits' can be had here") as fault:
        station.offer_here([], None)
    assert str(fault.value).endswith("apt-get install bubblewrap; or allow it by --isolation limits")
    with pytest.raises(UsageError, match="isolation full cannot be had here: bubblewrap is not installed"):
        station.offer_here([], "full")
    assert station.offer_here([], "limits").levels == ("limits",)
