"""Files are written whole or not at all, and what a killed judge has left goes, and nothing else."""

from __future__ import annotations

import errno
import fcntl
import os
import signal
import stat
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from judge.files import new_file, replace_file, sweep

ROOT = Path(__file__).parents[2]
LEFT = ".judge-0123456789abcdef.tmp"
LONG_AGO = time.time() - 3600
both = pytest.mark.parametrize("write", [new_file, replace_file])


@pytest.fixture
def left(tmp_path):
    """What a judge left that was killed an hour ago."""
    path = tmp_path / LEFT
    path.write_bytes(b"half of i")
    os.utime(path, (LONG_AGO, LONG_AGO))
    return path


KILLED = """
import fcntl, os, signal, sys
from pathlib import Path
from judge import files
def die(*_, **__):
    os.kill(os.getpid(), signal.SIGKILL)
setattr(*{where}, die)
files.{write}(Path(sys.argv[1]), b"new" * 1000)
"""


@pytest.mark.parametrize(
    ("write", "where", "before"),
    [
        ("replace_file", '(Path, "replace")', b"old"),
        ("replace_file", '(fcntl, "flock")', None),
        ("new_file", '(Path, "unlink")', None),
    ],
)
def test_a_writer_that_is_killed_leaves_the_old_file_or_the_new_one(write, where, before, tmp_path):
    path = tmp_path / "page.html"
    if before:
        path.write_bytes(before)
    script = KILLED.format(write=write, where=where)
    command = [sys.executable, "-c", script, str(path)]
    ended = subprocess.run(command, env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=60, check=False)
    assert ended.returncode == -signal.SIGKILL
    there = path.read_bytes() if path.exists() else None
    assert there in (before, b"new" * 1000)
    (half,) = tmp_path.glob(".judge-*.tmp")
    os.utime(half, (LONG_AGO, LONG_AGO))
    replace_file(path, b"newer")
    assert [each.name for each in tmp_path.iterdir()] == ["page.html"]
    assert path.read_bytes() == b"newer"


@both
def test_what_cannot_be_written_leaves_nothing(write, tmp_path):
    with pytest.raises(OSError, match="too long"):
        write(tmp_path / ("x" * 300), b"whole")
    with pytest.raises(FileNotFoundError):
        write(tmp_path / "nowhere" / "page.html", b"whole")
    with pytest.raises(ValueError, match="null"):
        write(tmp_path / "a\0b", b"whole")
    assert list(tmp_path.iterdir()) == []


def test_a_new_file_takes_nobodys_place(tmp_path):
    path = tmp_path / "mine.py"
    path.write_bytes(b"mine")
    (tmp_path / "link.py").symlink_to("nowhere.py")
    for taken in (path, tmp_path / "link.py", tmp_path):
        with pytest.raises(FileExistsError):
            new_file(taken, b"stub")
    assert path.read_bytes() == b"mine"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["link.py", "mine.py"]


@pytest.mark.parametrize("number", [errno.EPERM, errno.EOPNOTSUPP])
def test_a_new_file_where_there_are_no_hard_links(number, tmp_path, monkeypatch):
    def refused(*_):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(Path, "hardlink_to", refused)
    new_file(tmp_path / "mine.py", b"stub")
    with pytest.raises(FileExistsError):
        new_file(tmp_path / "mine.py", b"other")
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [("mine.py", b"stub")]


def test_of_many_that_begin_one_file_one_wins(tmp_path):
    won = []

    def begin(number: int) -> None:
        try:
            new_file(tmp_path / "mine.py", str(number).encode() * 1000)
        except FileExistsError:
            return
        won.append(number)

    threads = [threading.Thread(target=begin, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (tmp_path / "mine.py").read_bytes() == str(*won).encode() * 1000
    assert len(list(tmp_path.iterdir())) == 1


def test_a_link_stays_a_link(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real/page.html")
    replace_file(tmp_path / "link", b"whole")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real" / "page.html").read_bytes() == b"whole"


@pytest.mark.parametrize(("umask", "mode"), [(0o022, 0o644), (0o077, 0o600)])
@both
def test_a_file_is_there_as_the_person_gives_files_and_nothing_beside_it(write, umask, mode, left, tmp_path):
    before = os.umask(umask)
    try:
        write(tmp_path / "page.html", b"whole")
    finally:
        os.umask(before)
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]
    assert (tmp_path / "page.html").read_bytes() == b"whole"
    found = (tmp_path / "page.html").stat()
    assert (stat.S_IMODE(found.st_mode), found.st_nlink) == (mode, 1)


@pytest.mark.parametrize("mode", [0o640, 0o755])
def test_a_file_that_is_replaced_keeps_its_permissions(mode, tmp_path):
    path = tmp_path / "page.html"
    path.write_bytes(b"old")
    path.chmod(mode)
    replace_file(path, b"new")
    assert stat.S_IMODE(path.stat().st_mode) == mode


@pytest.mark.parametrize("name", [".judge-0123.tmp", ".judge-0123456789abcdef.tmp.py"])
def test_a_file_of_another_name_stays_and_one_that_was_begun_just_now(name, left):
    other = left.with_name(name)
    other.write_bytes(b"mine")
    os.utime(other, (LONG_AGO, LONG_AGO))
    os.utime(left)
    sweep(left.parent)
    assert other.exists()
    assert left.exists()
    sweep(left.parent / "nowhere")


def test_one_whose_writer_lives_stays(left):
    with left.open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        sweep(left.parent)
        assert left.exists()
    sweep(left.parent)
    assert not left.exists()


def test_no_link_is_followed_and_nothing_else_is_touched(left, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    precious = left.rename(other / "precious")
    left.symlink_to(precious)
    os.utime(left, (LONG_AGO, LONG_AGO), follow_symlinks=False)
    (tmp_path / LEFT.replace("0", "1")).mkdir()
    os.mkfifo(tmp_path / LEFT.replace("0", "2"))
    os.utime(tmp_path / LEFT.replace("0", "2"), (LONG_AGO, LONG_AGO))
    sweep(tmp_path)
    assert precious.exists()
    assert len(list(tmp_path.iterdir())) == 4


@pytest.mark.skipif(os.geteuid() != 0, reason="needs root, to give a file away")
def test_another_users_file_stays(left):
    os.chown(left, 12345, 12345)
    sweep(left.parent)
    assert left.exists()
