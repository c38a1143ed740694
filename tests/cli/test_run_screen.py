from __future__ import annotations

import os
import re
import select
import subprocess
import sys
import time

import pytest
from cli_support import FLOOR, MEAN, ROOT

pytestmark = pytest.mark.slow

ESCAPE = "\x1b"


def on_a_terminal(*words: str, columns: int = 80, rows: int = 24, **settings: str) -> tuple[int, str]:
    """Run the command on a terminal of its own; its status and all that was written there."""
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "judge", *map(str, words)]
    environment = {**os.environ, "TERM": "xterm-256color", "PYTHONPATH": str(ROOT), **settings}
    import fcntl
    import struct
    import termios

    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
    with subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=theirs, env=environment) as running:
        os.close(theirs)
        written = _everything(ours)
        status = running.wait(timeout=60)
    os.close(ours)
    return status, written.replace("\r\n", "\n")


def _everything(terminal: int) -> str:
    parts = []
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if select.select([terminal], [], [], 1)[0]:
            try:
                part = os.read(terminal, 65536)
            except OSError:  # Linux says so when the other side is closed
                break
            if not part:
                break
            parts.append(part)
    return b"".join(parts).decode()


def test_an_accepted_submission(judge, submit):
    ended = judge("run", "middle", submit(MEAN))
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[:3] == ["AC  mine.py  middle, its function called", "", "  3 groups accepted"]
    ended = judge("run", "middle", "mine.py", "--all")
    first, *_, last = ended.lines
    assert first == "mine.py  middle, its function called"
    assert last.startswith("AC  accepted, 100 of 100 points, 52 cases, ")
    rows = [line.split() for line in ended.lines if " AC " in line and line.startswith("  ")]
    assert rows == [
        ["examples", "AC", "2/2", "10"],
        ["whole", "AC", "20/20", "40"],
        ["half", "AC", "30/30", "50"],
    ]


def test_a_wrong_one_shows_the_failing_case_and_the_verdict_last(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--all")
    assert ended.status == 1
    at = ended.lines.index("  examples, case 1")
    assert [line.split(None, 1) for line in ended.lines[at + 1 : at + 5]] == [
        ["input", "a=1, b=2"],
        ["wanted", "1.5"],
        ["got", "1"],
        ["why", "the answer is off by 0.5, relative error 0.33 (2.25e+15 ulps)"],
    ]
    assert ended.lines[-1].startswith("WA  wrong answer, 40 of 100 points, 21 of 52 cases")
    assert ["half", "WA", "0/30", "0", "of", "50"] in [line.split() for line in ended.lines]


def test_several_end_with_a_table(judge, submit):
    submit(MEAN, "team/a.py")
    submit(FLOOR, "team/b.py")
    submit("x = (\n", "team/c.py")
    ended = judge("run", "middle", "team")
    assert ended.status == 1
    assert ended.lines[-1] == "1 of 3 accepted  middle"
    table = [line.split() for line in ended.lines[-5:-2]]
    assert [row[:3] for row in table] == [
        ["team/a.py", "AC", "100"],
        ["team/b.py", "WA", "40"],
        ["team/c.py", "CE", "0"],
    ]
    assert table[1][-3:] == ["examples,", "case", "1"]


def test_quietly_only_the_verdicts(judge, submit):
    submit(MEAN, "team/a.py")
    submit(MEAN, "team/b.py")
    assert len(judge("run", "-q", "middle", "team/a.py").lines) == 1
    broken = judge("run", "-q", "middle", submit("x = (\n"))
    assert broken.out.startswith("CE  does not compile: SyntaxError: '(' was never closed (line 1")
    ended = judge("run", "-q", "middle", "team")
    assert len(ended.lines) == 5
    assert ended.lines[-1] == "2 of 2 accepted  middle"


@pytest.mark.parametrize(
    ("source", "verdict", "words"),
    [
        ("def middle(a, b)\n", "CE", "line 1"),
        (b"s = '\xff'\n", "CE", "not UTF-8"),
        ("def middle(a, b):\n    return a / 0\n", "RTE", "ZeroDivisionError"),
        ("def midle(a, b):\n    return a\n", "WA", "line 1  there is no middle; is midle meant to be it?"),
        ("def middle(a, b):\n    return str(a)\n", "WA", "str"),
        ("def middle(a, b):\n    while True: pass\n", "TLE", "limit"),
    ],
)
def test_every_verdict_says_why(source, verdict, words, judge, submit):
    ended = judge("run", "middle", submit(source), "--group", "examples")
    assert ended.status == 1
    assert words in ended.out
    assert ended.lines[-1].startswith(f"{verdict}  ")
    assert "Traceback" not in ended.out + ended.err


def test_what_a_submission_says_cannot_steer_the_terminal(judge, submit):
    source = "def middle(a, b):\n    raise ValueError('\\x1b[2J\\x07\\u202e')\n"
    ended = judge("run", "middle", submit(source))
    assert ended.status == 1
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]", ended.out)


def test_plain_in_a_pipe(process, submit, tmp_path):
    submit(FLOOR)
    ended = process("run", "middle", tmp_path / "mine.py", FORCE_COLOR="1")
    assert ESCAPE not in ended.out + ended.err


def test_coloured_on_a_terminal(submit, tmp_path):
    submit(MEAN)
    status, written = on_a_terminal("run", "middle", tmp_path / "mine.py")
    assert status == 0
    assert f"{ESCAPE}[32mAC{ESCAPE}[0m" in written


@pytest.mark.parametrize("settings", [{"NO_COLOR": "1"}, {"TERM": "dumb"}])
def test_plain_on_a_terminal_where_that_is_asked_for(settings, submit, tmp_path):
    submit(MEAN)
    status, written = on_a_terminal("run", "middle", tmp_path / "mine.py", **settings)
    assert status == 0
    assert ESCAPE not in written


@pytest.mark.parametrize("columns", [40, 50, 80, 200])
def test_nothing_is_wider_than_the_terminal(columns, judge, submit, monkeypatch):
    submit(MEAN, "a/rather/long/path/to/some-submission.py")
    submit(FLOOR, "a/rather/long/path/to/some-other-submission.py")
    monkeypatch.setenv("COLUMNS", str(columns))
    for ended in (judge("run", "middle", "a/rather/long/path/to"), judge("list"), judge("verify", "middle")):
        # A command to be copied is the one line that is never broken.
        assert max(len(line) for line in ended.lines if " judge replay " not in line) <= columns
        assert not [line for line in ended.lines if line != line.rstrip()]


def test_a_long_run_shows_a_bar_on_a_terminal(submit, tmp_path):
    submit("import time\ndef middle(a, b):\n    time.sleep(0.03)\n    return (a + b) / 2\n")
    status, written = on_a_terminal("run", "middle", tmp_path / "mine.py", NO_COLOR="1", COLUMNS="100")
    assert status == 0
    assert "52/52" in written
    assert written.rstrip().splitlines()[-1].startswith("AC  accepted")
