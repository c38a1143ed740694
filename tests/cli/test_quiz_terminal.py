"""`judge quiz` on a terminal: figures are drawn and fit, Ctrl-C and Ctrl-D leave in peace."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import sys
import termios
import time
from pathlib import Path

import pytest
from cli_support import MEAN

from judge.kata.history import History

pytestmark = pytest.mark.slow

SECONDS = 60
ESCAPES = re.compile(r"\x1b\[[0-9;?]*[a-zA-Z]")


class Terminal:
    """A judge at work on a terminal of so many rows and columns; a context manager."""

    def __init__(self, words, rows=24, columns=80):
        self._ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        settings = {**os.environ, "TERM": "xterm", "PYTHONIOENCODING": "utf-8"}
        self._process = subprocess.Popen(
            [sys.executable, "-m", "judge", *words],
            stdin=theirs,
            stdout=theirs,
            stderr=theirs,
            env=settings,
            start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )
        os.close(theirs)
        self._read = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        os.close(self._ours)

    def until(self, text):
        """All that was shown since the last time, up to where `text` stands for the first time."""
        end = time.monotonic() + SECONDS
        while text.encode() not in self._read:
            if time.monotonic() > end or not self._more(end):
                raise AssertionError(f"{text!r} is not shown: {self.shown()}")
        at = self._read.index(text.encode()) + len(text.encode())
        found, self._read = self._read[:at], self._read[at:]
        return ESCAPES.sub("", found.decode("utf-8")).replace("\r\n", "\n")

    def shown(self):
        return ESCAPES.sub("", self._read.decode("utf-8", "replace"))

    def type(self, text):
        os.write(self._ours, text.encode())

    def ended(self):
        """The exit status, and what was shown at the end."""
        end = time.monotonic() + SECONDS
        while self._more(end):
            pass
        return self._process.wait(SECONDS), self.shown().replace("\r\n", "\n")

    def _more(self, end):
        if not select.select([self._ours], [], [], max(0, end - time.monotonic()))[0]:
            return False
        try:
            read = os.read(self._ours, 65536)
        except OSError:  # nobody is left at the other side
            return False
        self._read += read
        return bool(read)


def drawn(text):
    """The rows that hold braille characters."""
    return [row for row in text.split("\n") if re.search("[\u2801-\u28ff]", row)]


@pytest.mark.parametrize("card", ["junior/points-drawn", "middle/first-hit-drawn", "senior/tags-drawn"])
@pytest.mark.parametrize(("rows", "columns"), [(24, 80), (24, 40), (50, 100)])
def test_a_question_with_its_figure_fits_the_screen(card, rows, columns):
    words = ["quiz", "--card", card, "--cards", "1", "--seed", "4"]
    with Terminal(words, rows, columns) as terminal:
        shown = terminal.until(" > ")
        lines = shown.split("\n")
        assert len(lines) <= rows
        assert all(len(line) <= columns for line in lines)
        assert len(drawn(shown)) >= 7
        assert "wanted" not in shown
        terminal.type("?\n")
        assert "not known" in terminal.until("To drill")
        assert terminal.ended()[0] == 0


def test_where_there_is_no_room_the_figure_is_told_in_numbers():
    with Terminal(["quiz", "--card", "middle/order-drawn", "--seed", "4"], 24, 30) as terminal:
        shown = terminal.until(" > ")
        assert drawn(shown) == []
        assert "centre (" in " ".join(shown.split())


@pytest.mark.parametrize(("key", "status"), [("\x03", 130), ("\x04", 0)])
def test_ctrl_c_and_ctrl_d_keep_what_was_answered(key, status):
    with Terminal(["quiz", "halves", "--seed", "3"]) as terminal:
        terminal.until(" > ")
        terminal.type("3.5\n")
        terminal.until("2 of 2")
        terminal.until(" > ")
        terminal.type(key)
        terminal.until("1 of 1 card known")
        ended = terminal.ended()
    assert ended[0] == status
    assert "Traceback" not in ended[1]
    with History.open(reading=True) as history:
        assert [each.card for each in history.answers()] == ["halves/half-of-seven"]


def test_the_kata_of_an_interview_is_judged_when_its_file_is_saved():
    words = ["quiz", "--interview", "--cards", "0", "--kata", "middle", "--minutes", "60"]
    with Terminal(words, 40, 100) as terminal:
        terminal.until("q to go on")
        terminal.type("what\n")
        terminal.until("an empty line has the file judged")
        terminal.until("q to go on")
        Path("middle_interview.py").write_text(MEAN)
        terminal.until("accepted, 100 of 100 points")
        terminal.until("middle: AC, 100 of 100 points after 1 run")
        assert terminal.ended()[0] == 0


def test_ctrl_c_in_the_kata_ends_with_the_page():
    with Terminal(["quiz", "--interview", "--cards", "0", "--kata", "middle"]) as terminal:
        terminal.until("q to go on")
        terminal.type("\x03")
        terminal.until("middle: not judged")
        assert terminal.ended()[0] == 130
