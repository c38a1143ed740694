"""What the judge makes of what a child left behind, which may be anything, forged or torn."""

from __future__ import annotations

import signal

import pytest
from sandboxed import limits

from judge.sandbox import Reply, Stop, outcome
from judge.sandbox.container import Done
from judge.sandbox.inside import wire
from judge.sandbox.outcome import end_of, overrun, parse_replies

GOOD = b"[0,1],\n"
NO_NOTE = (wire.NO_NOTE, "")
LIMITS = limits(cpu_seconds=1.0, memory_bytes=1 << 20, output_bytes=100)


def done(status=0, reason=wire.NOT_KILLED, cpu=0.0, peak=0):
    return Done(status, reason, round(cpu * 1e9), 0, peak, 1)


@pytest.mark.parametrize(
    "line",
    [
        b"[0,NaN]", b"[0,-Infinity]", b"[0,1", b"0,1]", b"[[[", b"[" * 10**5, b"x", b"", b"\xff", b"null",
        b"7", b"[]", b"[0]", b"[0,1,2]", b"[2,1]", b"[true,1]x", b"[1,7]", b'["0",1]', b'{"0":1}',
        b"[0,1],[0,1]",
        b"[0,1]],[[0,1]", b"[0,1],\r", b"[0," + b"9" * 5000 + b"]",
    ],
)  # fmt: skip
@pytest.mark.parametrize("long", [1, outcome.LONG])  # long ones are parsed line by line
def test_a_line_in_another_form_ends_the_replies_before_it(line, long, monkeypatch):
    monkeypatch.setattr(outcome, "LONG", long)
    for after in (b"", GOOD):
        replies, kept_form = parse_replies(GOOD * 2 + line + b",\n" + after, 9)
        assert replies == [Reply(Stop.ANSWERED, 1)] * 2
        assert not kept_form
    assert parse_replies(GOOD * 2, 2) == ([Reply(Stop.ANSWERED, 1)] * 2, True)


@pytest.mark.parametrize("length", range(1, len(GOOD)))
def test_a_reply_cut_short_is_none_nor_one_more_than_there_are_calls(length):
    assert parse_replies(GOOD + GOOD[:length], 3) == ([Reply(Stop.ANSWERED, 1)], False)
    assert parse_replies(GOOD * 4, 3) == ([Reply(Stop.ANSWERED, 1)] * 3, False)


def test_the_text_of_an_exception_is_one_printable_line():
    (reply,), kept_form = parse_replies(b'[1,"a\\nb\\u001b[2J' + b"x" * 5000 + b'"],\n', 1)
    assert kept_form
    assert reply.detail.isprintable()
    assert len(reply.detail) <= 1000


@pytest.mark.parametrize(
    ("ended", "printed", "note", "stop"),
    [
        (done(), 100, NO_NOTE, None),
        (done(cpu=1.0, peak=1 << 20), 100, NO_NOTE, None),
        (done(), 101, NO_NOTE, Stop.OUTPUT),
        (done(cpu=1.001), 0, NO_NOTE, Stop.CPU),
        (done(signal.SIGKILL, wire.FOR_CPU), 0, NO_NOTE, Stop.CPU),
        (done(signal.SIGXCPU), 0, NO_NOTE, Stop.CPU),
        (done(signal.SIGKILL, wire.FOR_WALL), 0, NO_NOTE, Stop.WALL),
        (done(peak=(1 << 20) + 1), 0, NO_NOTE, Stop.MEMORY),
        (done(1 << 8), 0, (wire.NO_MEMORY, "MemoryError (line 2)"), Stop.MEMORY),
        (done(1 << 8), 0, (wire.TOO_MUCH, "too long"), Stop.OUTPUT),
        # what was measured comes before what the child says, and filling memory takes time
        (done(signal.SIGKILL, wire.FOR_CPU, cpu=2.0, peak=2 << 20), 200, NO_NOTE, Stop.MEMORY),
        (done(signal.SIGKILL, wire.FOR_CPU), 200, (wire.NO_MEMORY, ""), Stop.CPU),
        (done(signal.SIGKILL, wire.FOR_WALL), 200, (wire.TOO_MUCH, ""), Stop.WALL),
    ],
)
def test_the_limit_that_was_passed(ended, printed, note, stop):
    found = overrun(ended, LIMITS, printed, note)
    assert (found and found[0]) == stop


@pytest.mark.parametrize(
    ("status", "note", "end"),
    [
        (0, NO_NOTE, (Stop.ANSWERED, "exit status 0")),
        (7 << 8, NO_NOTE, (Stop.EXITED, "exit status 7")),
        (1 << 8, (wire.RAISED, "E (line 1)"), (Stop.EXCEPTION, "E (line 1)")),
        (signal.SIGKILL, NO_NOTE, (Stop.EXITED, "killed by SIGKILL")),
        (signal.SIGKILL, (wire.RAISED, "E"), (Stop.EXITED, "killed by SIGKILL")),
        (signal.SIGSEGV, NO_NOTE, (Stop.EXITED, "killed by SIGSEGV (did it call itself too deeply?)")),
        (45, NO_NOTE, (Stop.EXITED, "killed by signal 45")),
    ],
)
def test_the_end_of_a_child_within_its_limits(status, note, end):
    assert end_of(done(int(status)), note) == end
