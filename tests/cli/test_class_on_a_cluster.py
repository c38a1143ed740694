"""`judge class --on`: a dask scheduler and workers on this machine, killed in the middle.

What `--on` refuses in a line is among the transcripts: refused/class-on.txt. What the executor does when
workers die is in tests/unit/test_executors.py.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys

import pytest
from cli_support import FLOOR, MEAN, ROOT

pytest.importorskip("distributed", reason="distributed is not installed")

from clusters import served

pytestmark = pytest.mark.slow

SOURCES = (
    MEAN,
    FLOOR,
    "def middle(a, b):\n    return a / 0\n",
    "def middle(a, b)\n",
)
STUDENTS = 9
TELLING = ("student", "problem", "file", "verdict", "score", "mistake")
SETTINGS = """
distributed:
  comm:
    default-scheme: tls
    require-encryption: true
    tls:
      ca-file: {0}/cert.pem
      scheduler: {{cert: {0}/cert.pem, key: {0}/key.pem}}
      worker: {{cert: {0}/cert.pem, key: {0}/key.pem}}
      client: {{cert: {0}/cert.pem, key: {0}/key.pem}}
"""


def facts(row):
    """What may not depend on where a row was judged."""
    result = row["result"]
    groups = [(group["name"], group["passed"]) for group in result["groups"]]
    failure = {**(result["failure"] or {}), "seconds": None}
    return [row[name] for name in TELLING], groups, failure, result["counterexample"]


def rows_of(text):
    return [row for row in map(json.loads, text.splitlines()) if "student" in row]


@pytest.fixture
def homework(tmp_path):
    """Files that all differ."""
    folder = tmp_path / "homework"
    for number in range(STUDENTS):
        place = folder / f"s{number:02}"
        place.mkdir(parents=True)
        (place / "middle.py").write_text(f"{SOURCES[number % len(SOURCES)]}\n# {number}\n")
    return folder


def certified(folder):
    """A new certificate, and dask's configuration for it, as the manual says: the value of $DASK_CONFIG."""
    openssl = shutil.which("openssl") or pytest.skip("openssl is not installed")
    folder.mkdir()
    words = "req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3 -subj /CN=judge"
    files = ["-keyout", folder / "key.pem", "-out", folder / "cert.pem"]
    subprocess.run([openssl, *words.split(), *files], check=True, capture_output=True)
    (folder / "tls.yaml").write_text(SETTINGS.format(folder))
    return str(folder)


def client(*words, **settings):
    """`judge class` as a process, whose rows are read one by one."""
    command = [sys.executable, "-m", "judge", "class", *map(str, words), "--json"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **settings}
    return subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    )


def ended(process):
    with process:
        rest = process.stdout.read()  # `communicate` would lose what was read ahead of a row
        said = process.stderr.read()
    return process.returncode, rows_of(rest), said


def kill_its_worker(row):
    """The worker has its next submission by now."""
    os.kill(int(row["worker"].rpartition(":")[2]), signal.SIGKILL)


@pytest.mark.nightly
def test_certificates_keep_strangers_out(homework, tmp_path):
    own, other = certified(tmp_path / "own"), certified(tmp_path / "other")
    with served(tmp_path, 1, DASK_CONFIG=own) as cluster:
        assert cluster.address.startswith("tls://")
        for where, config in ((cluster.file, other), (cluster.address.replace("tls", "tcp"), str(tmp_path))):
            status, rows, said = ended(client(homework, "--on", where, DASK_CONFIG=config))
            assert (status, rows) == (3, [])
            assert said.splitlines()[-1].startswith("judge: what listens at ")
        status, rows, _ = ended(client(homework, "--on", cluster.file, DASK_CONFIG=own))
    assert (status, len(rows)) == (1, STUDENTS)


@pytest.mark.nightly
def test_killed_workers_and_a_killed_client_lose_nothing(homework, tmp_path, judge):
    plain = rows_of(judge("class", homework, "--json", "-j", 2).out)
    (tmp_path / "homework.judge.sqlite3").unlink()
    with served(tmp_path, 2) as cluster:
        words = homework, "--on", cluster.file
        first = client(*words)
        before = [json.loads(first.stdout.readline())]
        kill_its_worker(before[0])
        before.append(json.loads(first.stdout.readline()))
        first.kill()
        ended(first)
        second = client(*words)
        rows = [json.loads(second.stdout.readline()) for _ in range(3)]
        kill_its_worker(rows[2])
        status, rest, said = ended(second)
    rows += rest
    assert all(row["kept"] for row in rows[:2])
    assert len(rows) == STUDENTS
    assert {row["file"]: facts(row) for row in rows} == {row["file"]: facts(row) for row in plain}
    assert status == 1
    assert "kept from before" in said
    assert len({row["result"]["isolation"] for row in rows if row["verdict"] != "CE"} - {"limits"}) == 1


def test_a_lost_scheduler_is_a_line_and_what_is_judged_is_kept(homework, tmp_path, judge):
    with served(tmp_path, 1) as cluster:
        process = client(homework, "--on", cluster.address)
        first = rows_of(process.stdout.readline())
        cluster.scheduler.kill()
        status, rest, said = ended(process)
    assert status == 3
    line = f"judge: the scheduler at {cluster.address} is lost; what is judged is kept, and the same command"
    assert said.splitlines()[-1] == f"{line} goes on"
    assert "Traceback" not in said
    outcome = judge("class", homework, "--on", cluster.address)
    assert outcome.status == 3
    assert "(connection refused); start it with 'dask scheduler'" in outcome.err
    rows = rows_of(judge("class", homework, "--json").out)
    assert sorted(row["file"] for row in rows) == [f"s{at:02}/middle.py" for at in range(STUDENTS)]
    assert {row["file"] for row in first + rest} <= {row["file"] for row in rows if row["kept"]}


@pytest.mark.nightly
def test_a_worker_that_would_judge_otherwise_is_named_once_and_left_out(homework, tmp_path, pack, judge):
    other = tmp_path / "pack"
    shutil.copytree(pack, other)
    with (other / "problems" / "middle" / "problem.toml").open("a") as file:
        file.write("\n# another version\n")
    with served(tmp_path, 1, JUDGE_PROBLEMS=str(other / "problems")) as cluster:
        alone = judge("class", homework, "--on", cluster.address)
        assert alone.status == 2
        assert "can judge this: middle on " in alone.err
        cluster.add(1, threads=2)
        cluster.add(1, JUDGE_PROBLEMS=str(pack / "problems"))
        outcome = judge("class", homework, "--on", cluster.address, "--json")
    assert outcome.status == 1
    rows = rows_of(outcome.out)
    assert len(rows) == STUDENTS
    assert not any(row["verdict"] == "JE" for row in rows)
    said = [line for line in outcome.err.splitlines() if "is left out" in line]
    assert len(said) == len(set(said)) == 2
    assert sum("the problem's files (" in line for line in said) == 1
    assert sum("it has 2 threads; start it with --nthreads 1" in line for line in said) == 1


def test_a_missing_package_is_a_line(homework, judge, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    outcome = judge("class", homework, "--on", "tcp://127.0.0.1:1")
    assert outcome.status == 2
    assert outcome.err.endswith("which is not installed; pip install 'circle-line-judge[cluster]'\n")
