"""A program that is talked with can neither stop the judge nor mislead it by what it does to its pipes."""

from __future__ import annotations

import sys

import pytest
from attackers import LEVELS

from judge.sandbox import Limits, Stop, open_box
from judge.sandbox.boundary import Conversation, ProgramResult

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="the pipes of others are as the system has them"),
    pytest.mark.parametrize("level", LEVELS, indirect=True),
]

LIMITS = Limits(cpu_seconds=0.5, wall_seconds=30.0, memory_bytes=256 << 20, output_bytes=300_000)
RIGHT = b"print(int(input()) + 1, flush=True)\n"
BEGIN = "import fcntl, os, signal, sys, threading, time\n"


def _heard(
    source: str, level: str, said: bytes = b"", limits: Limits = LIMITS
) -> tuple[ProgramResult, bytes]:
    """What came of a program, and all that was heard of it; the box runs it again."""
    lines = []

    def talk(line: Conversation) -> bool:
        line.say(said)
        while data := line.hear():
            lines.append(data)
        return True

    with open_box((BEGIN + source).encode(), "mine.py", level=level) as box:
        result = box.run_program(talk, limits)
        heard = b"".join(lines)
        assert box.run_program(talk, limits).stop is result.stop
    return result, heard


@pytest.mark.parametrize(
    ("source", "stop", "heard"),
    [
        ("while True: os.write(1, b'x')", Stop.OUTPUT, b""),
        ("while True: os.write(1, b'x\\n' * 999)", Stop.OUTPUT, None),
        ("while True: os.write(1, bytes(9999))", Stop.OUTPUT, b""),
        ("while True: os.write(2, b'x' * 9999)", Stop.OUTPUT, b""),
        ("os.write(1, b'a\\0b\\xff\\xc3\\n\\r\\n')", Stop.ANSWERED, b"a\0b\xff\xc3\n\r\n"),
        ("os.write(1, b'9' * 200_000)", Stop.ANSWERED, b"9" * 200_000),
        ("os.close(1)\nos.close(0)\nwhile True: pass", Stop.CPU, b""),
        ("os.close(1)\nos.close(0)\nos._exit(3)", Stop.EXITED, b""),
        ("os.close(0)\nos.write(1, b'1\\n')", Stop.ANSWERED, b"1\n"),
        ("os.write(1, b'1\\n')\nos.kill(os.getpid(), signal.SIGSTOP)", Stop.EXITED, b"1\n"),
        ("os.write(1, b'1\\n')\nos.kill(os.getpid(), signal.SIGKILL)", Stop.EXITED, b"1\n"),
        ("os.set_blocking(0, False)\nos.set_blocking(1, False)\nos.write(1, b'1\\n')", Stop.ANSWERED, b"1\n"),
        ("threading.Thread(target=time.sleep, args=(99,), daemon=True).start()\nos.write(1, b'1\\n')",
         Stop.ANSWERED, b"1\n"),
    ],
)  # fmt: skip
def test_what_it_does_to_its_pipes_ends_with_it(
    level: str, source: str, stop: Stop, heard: bytes | None
) -> None:
    result, lines = _heard(source, level)
    assert result.stop is stop, result
    assert heard is None or lines + result.stdout == heard or stop is Stop.OUTPUT


def test_it_does_not_read_what_it_is_told(level: str) -> None:
    short = LIMITS._replace(wall_seconds=2.0)
    result, lines = _heard("os.write(1, b'1\\n')\ntime.sleep(99)", level, b"x" * (1 << 22), short)
    assert (result.stop, lines) == (Stop.WALL, b"1\n")


def test_it_floods_whoever_talks_on(level: str) -> None:
    """Nobody listens: what comes meanwhile is counted all the same."""
    result, _ = _heard("while True: os.write(1, b'x' * 9999)", level, b"x" * (1 << 22))
    assert result.stop is Stop.OUTPUT


@pytest.mark.parametrize("way", ["os.fork()", "os.fork() or os.setsid() or os.fork()"])
def test_what_it_leaves_behind_holds_no_pipe(level: str, way: str) -> None:
    """Where it may have a child at all, that ends with it."""
    source = f"""
try:
    pid = {way}
except OSError:
    pid = 1
if not pid:
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    time.sleep(99)
os.write(1, b'1\\n')
os._exit(0)
"""
    result, lines = _heard(source, level)
    assert result.stop in (Stop.ANSWERED, Stop.EXITED)
    assert lines in (b"1\n", b"1\n1\n", b"")


def test_it_opens_the_other_ends_of_its_pipes(level: str) -> None:
    """They are its own two pipes and no more: it may talk to itself, until it ends."""
    source = """
for number, way in ((0, os.O_WRONLY), (1, os.O_RDONLY), (0, os.O_RDWR)):
    try:
        fcntl.fcntl(number, fcntl.F_SETPIPE_SZ, 1 << 20)
    except OSError:
        pass
    try:
        os.open(f'/proc/self/fd/{number}', way | os.O_NONBLOCK)
    except OSError:
        pass
os.write(1, b'1\\n')
"""
    result, lines = _heard(source, level)
    assert result.stop in (Stop.ANSWERED, Stop.EXCEPTION)
    assert lines == b"1\n"


def test_one_that_is_stopped_costs_the_next_nothing(level: str) -> None:
    """A stop that comes too late is nobody's, however often it comes."""

    def unheard(_line: Conversation) -> bool:
        return False

    def answered(line: Conversation) -> bool:
        line.say(b"41\n")
        return line.hear() == b"42\n"

    with open_box(RIGHT, "mine.py", level=level) as box:
        for _ in range(20):
            assert box.run_program(unheard, LIMITS).stop in (Stop.EXITED, Stop.EXCEPTION)
            assert box.run_program(answered, LIMITS).stop is Stop.ANSWERED
            assert box.run_program(b"1", LIMITS).stdout == b"2\n"


def test_what_a_talk_raises_is_raised_and_the_program_ended(level: str) -> None:
    def broken(line: Conversation) -> bool:
        raise KeyError("broken")

    with open_box(b"while True: pass", "mine.py", level=level) as box:
        with pytest.raises(KeyError, match="broken"):
            box.run_program(broken, LIMITS._replace(cpu_seconds=1e6, wall_seconds=1e6))
        assert box.run_program(b"", LIMITS).stop is Stop.CPU
