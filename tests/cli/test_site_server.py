"""`judge site --open`: what is served to whom, and what is made when it is asked for."""

from __future__ import annotations

import socket
import struct
import time
from contextlib import ExitStack
from pathlib import Path
from threading import Thread
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest

from judge.cli.commands import site as command
from judge.errors import UsageError
from judge.problem.find import find_problem
from judge.site import serve
from judge.site.build import Site
from judge.site.serve import SiteServer

KATAS = Path(__file__).parent.parent / "fixtures" / "katas" / "problems"
KATA = "rises"


@pytest.fixture
def ports(monkeypatch):
    """Two ports that nobody has."""
    with ExitStack() as taken:
        free = [taken.enter_context(socket.create_server(("127.0.0.1", 0))) for _ in range(2)]
        found = [each.getsockname()[1] for each in free]
    monkeypatch.setattr(serve, "PORTS", found)
    monkeypatch.setattr(command, "PORTS", found)
    return found


@pytest.fixture
def made(tmp_path):
    parts = tmp_path / "parts"
    parts.mkdir()
    return Site(tmp_path / "site", [find_problem(each, [KATAS]) for each in ("by-size", KATA)], [], parts)


@pytest.fixture
def server(ports, made):
    with SiteServer(made, lambda: b"{}") as found:
        yield found


def asked(server, path, **headers):
    """What is answered, and the status."""
    try:
        with urlopen(Request(server.address + path, headers=headers), timeout=60) as answer:
            return answer.status, answer.read()
    except HTTPError as fault:
        return fault.code, b""


def test_the_same_port_while_it_is_free_then_the_next(ports, made):
    with SiteServer(made, bytes) as first, SiteServer(made, bytes) as second:
        assert [first.server_port, second.server_port] == ports
        with pytest.raises(UsageError, match=f"{ports[0]} to {ports[1]}"):
            SiteServer(made, bytes)
    with SiteServer(made, bytes) as again:
        assert again.server_port == ports[0]


def test_a_name_of_elsewhere_that_leads_here_is_refused(server):
    port = server.server_port
    for host in (f"127.0.0.1:{port}", f"localhost:{port}"):
        assert asked(server, "katas.json", Host=host)[0] == 200
    for host in ("evil.example", f"evil.example:{port}", "127.0.0.1", f"127.0.0.1:{port}.evil.example"):
        assert asked(server, "katas.json", Host=host) == (403, b"")
        assert asked(server, "mine.json", Host=host) == (403, b"")


def test_nothing_beside_the_site_is_served(server, tmp_path):
    (tmp_path / "secret.txt").write_text("secret")
    (server.site.out / "link.txt").symlink_to(tmp_path / "secret.txt")
    (server.site.out / "folder").symlink_to(tmp_path)
    assert asked(server, "link.txt") == (403, b"")
    assert asked(server, "folder/secret.txt") == (403, b"")
    assert asked(server, "../secret.txt")[0] == 404
    assert asked(server, "%2e%2e/secret.txt")[0] == 404
    assert asked(server, "kata/")[0] == 404  # no list of files
    assert asked(server, "")[0] == 200


def test_what_is_asked_for_is_made_first_and_its_client_waits(server):
    answers, stages = [], []
    client = Thread(target=lambda: answers.append(asked(server, f"kata/{KATA}.zip")))
    client.start()
    while server.asked.empty():
        time.sleep(0.01)
    assert not answers
    server.build(lambda name, *_: stages.append(name))
    client.join()
    assert answers[0][0] == 200
    assert answers[0][1].startswith(b"PK")
    assert stages[0] == KATA
    assert sorted({*stages}) == ["", "by-size", "index", "quiz", KATA]
    assert stages.count(KATA) == 2  # its zip, and its texts
    for path in ("kata/by-size.json", "explore/", "quiz.json"):
        assert asked(server, path)[0] == 200


def test_a_kata_that_cannot_be_made_costs_itself_only(server, monkeypatch):
    page = server.site._make

    def broken(name):
        if name == f"kata/{KATA}.zip":
            raise UsageError("it is broken")
        page(name)

    monkeypatch.setattr(server.site, "_make", broken)
    server.build(None)
    assert list(map(str, server.site.faults)) == ["it is broken"]
    assert asked(server, f"kata/{KATA}.zip")[0] == 404
    assert asked(server, "kata/by-size.zip")[0] == 200


def test_a_client_that_hangs_up_is_no_fault(server, capsys):
    (server.site.out / "large").write_bytes(bytes(32 << 20))
    for _ in range(3):
        with socket.create_connection(("127.0.0.1", server.server_port)) as client:
            client.sendall(f"GET /large HTTP/1.1\r\nHost: 127.0.0.1:{server.server_port}\r\n\r\n".encode())
            client.recv(1)
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    assert asked(server, "katas.json")[0] == 200
    time.sleep(0.2)  # for the threads of the others
    assert capsys.readouterr().err == ""


def test_it_is_served_and_all_of_it_made_until_ctrl_c(judge, ports, monkeypatch, tmp_path):
    class Pressed:
        def wait(self):
            raise KeyboardInterrupt

    (tmp_path / "parts").mkdir()
    monkeypatch.setattr(command, "parts", lambda *_: tmp_path / "parts")
    monkeypatch.setattr(command, "Event", Pressed)
    monkeypatch.setenv("PATH", str(tmp_path))  # no browser
    with socket.create_server(("127.0.0.1", ports[0])):
        ended = judge("site", "middle", "--open", "--out", "public")
    assert ended.status == 130
    assert ended.err.splitlines() == [
        f"judge: http://127.0.0.1:{ports[1]}/  open until Ctrl-C",
        f"judge: Your progress of port {ports[0]} is not seen here.",
        "judge: No browser here. Open the address above.",
        "",
    ]
    assert "1 kata made" in ended.out
    assert Path("public/kata/middle.zip").is_file()
