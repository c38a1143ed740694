"""What `judge worker` opens and leaves: no HTTP, no folder; and a client that comes too early waits."""

from __future__ import annotations

import os
import re
import signal
import socket
import threading
import time
from pathlib import Path

import pytest

pytest.importorskip("distributed")

from clusters import HERE, below, served

from judge.cluster.greeting import Offer
from judge.cluster.ring import Ring
from judge.cluster.where import Address
from judge.errors import JudgeError

pytestmark = pytest.mark.slow


def ports_of(pids):
    """The TCP ports at which processes listen."""
    inodes = set()
    for pid in pids:
        for entry in Path(f"/proc/{pid}/fd").glob("*"):
            try:
                found = re.fullmatch(r"socket:\[(\d+)\]", os.readlink(entry))  # noqa: PTH115
            except OSError:
                continue
            inodes |= {found[1]} if found else set()
    rows = [
        line.split()
        for name in ("tcp", "tcp6")
        for line in Path(f"/proc/net/{name}").read_text().splitlines()
    ]
    return {int(row[1].rpartition(":")[2], 16) for row in rows if row[3] == "0A" and row[9] in inodes}


def answer_of(port):
    """What comes back to a question by HTTP."""
    with socket.create_connection(("127.0.0.1", port), timeout=5) as line:
        line.settimeout(2)
        line.sendall(b"GET /sitemap.json HTTP/1.0\r\n\r\n")
        try:
            return line.recv(400)
        except OSError:
            return b""


@pytest.mark.nightly
def test_no_port_speaks_http():
    with served("--scheduler", HERE, "-j", "1") as (told, process):
        own = Address.of(told["address"]).port
        ports = ports_of([process.pid, *below(process)])
        assert own in ports
        assert len(ports) >= 2
        assert [port for port in ports if b"HTTP/" in answer_of(port)] == []


@pytest.mark.nightly
def test_a_killed_workers_folder_goes_with_the_next_one(tmp_path):
    with served("--scheduler", HERE, "-j", "1", TMPDIR=str(tmp_path)) as (_, process):
        (folder,) = tmp_path.glob("judge-box-*")
        assert folder.stat().st_mode & 0o777 == 0o700
        started = below(process)
        process.send_signal(signal.SIGKILL)
        process.wait()
    until = time.monotonic() + 60
    while any(
        Path(f"/proc/{pid}/cmdline").exists() and Path(f"/proc/{pid}/cmdline").read_bytes() for pid in started
    ):
        assert time.monotonic() < until, "its workers live on"
        time.sleep(0.1)
    assert folder.exists()
    os.utime(folder, (0, 0))  # it was made long ago
    with served("--scheduler", HERE, TMPDIR=str(tmp_path)):
        assert not folder.exists()
        assert len(list(tmp_path.glob("judge-box-*"))) == 1
    until = time.monotonic() + 60
    while list(tmp_path.glob("judge-box-*")) and time.monotonic() < until:
        time.sleep(0.1)
    assert list(tmp_path.glob("judge-box-*")) == []


def test_a_client_that_comes_while_no_worker_is_there_waits_for_one():
    from distributed import LocalCluster, Worker

    here = Offer({"judge": "9 (def)"}, {}, ("full",))

    async def join(address):
        return await Worker(address, nthreads=1, resources=here.resources(), dashboard_address="127.0.0.1:0")

    said = []
    with LocalCluster(
        n_workers=0, processes=False, protocol="tcp://", host="127.0.0.1", dashboard_address="127.0.0.1:0"
    ) as cluster:
        address = Address.of(cluster.scheduler_address)
        with pytest.raises(JudgeError, match="has no workers"):
            Ring(address, None, here, patience=0.1).__enter__()
        late = []
        timer = threading.Timer(1.5, lambda: late.append(cluster.sync(join, cluster.scheduler_address)))
        timer.start()
        with Ring(address, None, here, say=said.append) as ring:
            assert ring.alive() == 1
        timer.join()
        cluster.sync(late[0].close)
    assert said == [f"there is no worker at {address} yet; waiting 60 s for one"]
