"""Calls and programs behind the boundary: what comes back, and what is made of what a child left."""

from __future__ import annotations

import math
import os
import signal
import sys
import time
from pathlib import Path

import pytest
from sandboxed import LIMITS, call, children, limits, require, run

import judge
from judge.errors import JudgeError, ShortageError
from judge.sandbox import LEVELS, Stop, levels, open_box, outcome
from judge.sandbox.boundary import Reply
from judge.sandbox.container import ChildEnd, Container, Lost
from judge.sandbox.inside import wire
from judge.sandbox.outcome import end_of, overrun, parse_replies
from judge.values.wire import number

NUMBERS = [(n,) for n in range(5)]
on_linux = pytest.mark.skipif(
    sys.platform != "linux", reason="processes are told by /proc or die as on Linux"
)


def stops(result):
    return [reply.stop for reply in result.replies]


def test_answers_come_back_in_order_and_exactly():
    values = [1, -7, 10**30, 0.1, -0.0, 5e-324, 1.7976931348623157e308, math.pi]
    result = call("def f(x): return (x, [x])", [(value,) for value in values])
    assert set(stops(result)) == {Stop.ANSWERED}
    for value, reply in zip(values, result.replies, strict=True):
        first, (second,) = reply.answer
        assert number(first) == number(second) == value
        assert type(number(first)) is type(value)
    assert math.copysign(1, result.replies[4].answer[0]) == -1


def test_what_it_makes_of_the_builtins_is_told_at_its_own_line():
    lost = "import builtins\nfor name in ('len', 'repr', 'type', 'print'): setattr(builtins, name, None)\n"
    found = call(f"{lost}def f(x): return len([x])", NUMBERS)
    assert {(reply.stop, reply.detail) for reply in found.replies} == {
        (Stop.EXCEPTION, "TypeError: 'NoneType' object is not callable (line 3)")
    }
    found = call(f"{lost}def f(x): return x", NUMBERS)
    assert [number(reply.answer) for reply in found.replies] == [0, 1, 2, 3, 4]


def test_a_series_has_one_module_and_the_next_finds_nothing_of_it():
    source = b"""
import math
calls = []
def f(n):
    calls.append(n)
    math.pi += 1
    return len(calls), math.pi
"""
    with open_box(source, "my.py") as box:
        first, second = (box.call("f", NUMBERS[:2], LIMITS) for _ in range(2))
        assert box.call("f", [], LIMITS).replies == ()
    assert [reply.answer for reply in first.replies] == [reply.answer for reply in second.replies]
    assert [reply.answer[0] for reply in second.replies] == [1, 2]
    assert second.replies[0].answer[1] == math.pi + 1


@pytest.mark.parametrize(
    ("body", "detail"),
    [
        ("sys.exit(4)", "SystemExit: 4 (line 4)"),
        ("raise ValueError('a\\nb' + 'x' * 9999)", "ValueError: a b" + "x" * 497 + " (line 4)"),
        ("return f(n)", "RecursionError: maximum recursion depth exceeded"),
        ("raise E", "E: (its text cannot be shown) (line 4)"),
        ("raise Lying('so')", "Lying: so (line 4)"),
    ],
)
def test_exceptions_are_told_in_one_line(body, detail):
    source = f"import sys\ndef f(n):\n    if n == 3:\n        {body}\n    return n\n"
    source += "class E(Exception):\n    def __str__(self): raise self\n"
    source += "@property\ndef lie(self): 1 / 0\n"
    source += "class Lying(OSError): __class__ = errno = code = __traceback__ = __dict__ = lie\n"
    result = call(source, NUMBERS)
    assert stops(result) == [Stop.ANSWERED] * 3 + [Stop.EXCEPTION, Stop.ANSWERED]
    assert result.replies[3].detail.startswith(detail)


@pytest.mark.parametrize("kind", ["SystemExit", "Exception"])
def test_a_program_s_exception_is_told_whatever_it_says_of_itself(kind):
    source = "@property\ndef lie(self): 1 / 0\n"
    source += f"class Lying({kind}): code = __class__ = __traceback__ = lie\n"
    result = run(source + "raise Lying(3)\n")
    assert result.stop in {Stop.EXITED, Stop.EXCEPTION}
    assert result.detail == ("exit status 3" if kind == "SystemExit" else "Lying: 3 (line 4)")


SEARCH = """
import ctypes, gc, sys
KEPT = "what/is/kept/here.py"
def f(sought):
    needle, seen = bytes(255 - b for b in sought), set()
    waiting = [sys.modules, gc.get_objects(), sys._getframe()]
    while waiting and len(seen) < 200_000:
        one = waiting.pop()
        if id(one) not in seen:
            seen.add(id(one))
            waiting += gc.get_referents(one)
    return sum(ctypes.string_at(page << 12, 4096).count(needle) for page in {number >> 12 for number in seen})
"""


@on_linux
@pytest.mark.parametrize("level", LEVELS[:2])
def test_no_name_of_what_is_hidden_stays_in_the_memory(level):
    require(level)
    room = limits(cpu_seconds=10.0, wall_seconds=30.0)
    hidden = [str(Path(judge.__file__).parent), str(Path(judge.__file__).parent.parent / "problems")]
    with open_box(SEARCH.encode(), "my.py", level=level) as box:
        for name in [*hidden, "what/is/kept/here.py"]:
            (reply,) = box.call("f", [([255 - byte for byte in name.encode()],)], room).replies
            assert (reply.answer == 1) is (name in hidden), (
                "it finds what it looks for itself, and nothing else"
            )


def test_a_call_that_closes_every_descriptor_loses_nothing():
    result = call("import os\ndef f(n):\n    if n == 1: os.closerange(0, 100)\n    return n", NUMBERS)
    assert [reply.answer for reply in result.replies] == [0, 1, 2, 3, 4]


@pytest.mark.slow
@on_linux
def test_an_interrupt_leaves_nothing_behind():
    def interrupt(*_):
        raise KeyboardInterrupt

    before = children()
    handler = signal.signal(signal.SIGALRM, interrupt)
    try:
        with open_box(b"import time\ndef f(n): time.sleep(n); return n", "my.py") as box:
            box.call("f", [(0,)], LIMITS)
            assert children() > before
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            with pytest.raises(KeyboardInterrupt):
                box.call("f", [(60,)], LIMITS)
            assert children() == before
            assert box.call("f", [(0,)], LIMITS).replies[0].answer == 0
        assert children() == before
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)


@pytest.mark.slow
@on_linux
def test_a_container_that_ends_by_itself_is_no_fault_of_the_submission():
    before = children()

    def kill_it():
        server = Path(f"/proc/{box._here()._pid}/stat")
        for pid in children() - before:
            os.kill(int(pid), signal.SIGKILL)
            os.waitid(os.P_PID, int(pid), os.WEXITED | os.WNOWAIT)
        while server.exists() and b") Z " not in server.read_bytes():
            time.sleep(0.001)

    with open_box(b"def f(n): return n", "my.py", level="limits") as box:
        assert stops(box.call("f", NUMBERS, LIMITS)) == [Stop.ANSWERED] * 5
        kill_it()
        with pytest.raises(ShortageError, match="the process that watches it has ended"):
            box.call("f", NUMBERS, LIMITS)
        assert stops(box.call("f", NUMBERS, LIMITS)) == [Stop.ANSWERED] * 5


def test_a_container_that_ends_before_anything_runs_is_started_again(monkeypatch):
    lost, answer = [], Container.answer

    def once(self, limits):
        if not lost:
            lost.append(self)
            self.close()
            raise Lost
        return answer(self, limits)

    monkeypatch.setattr(Container, "answer", once)
    with open_box(b"def f(n): return n", "my.py") as box:
        assert stops(box.call("f", NUMBERS, LIMITS)) == [Stop.ANSWERED] * 5
    assert lost


# -- whole programs ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ending", "stop", "detail"),
    [
        ("sys.exit(0)", Stop.ANSWERED, ""),
        ("sys.exit('no')", Stop.EXITED, "exit status 1"),
        ("import os; os._exit(9)", Stop.EXITED, "exit status 9"),
        ("import os; os.abort()", Stop.EXITED, "killed by SIGABRT"),
    ],
)
def test_a_program_ends_well_or_says_how(ending, stop, detail):
    result = run(f"import sys\nprint(1, flush=True)\n{ending}")
    assert (result.stop, result.stdout, result.detail) == (stop, b"1\n", detail)


def test_an_uncaught_exception_has_its_line_and_only_the_submissions_frames():
    result = run("def f():\n    return 1 / 0\nprint(5, flush=True)\nf()")
    assert (result.stop, result.detail) == (Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 2)")
    assert result.stdout == b"5\n"
    assert b"child.py" not in result.stderr
    assert result.stderr.startswith(
        b'Traceback (most recent call last):\n  File "/dev/fd/4", line 4, in <module>'
    )


# -- what a source is: names, lines and faults; and how a box opens and closes -------------------------------


def inspect(source):
    with open_box(source, "my.py") as box:
        return box.inspect()


def test_inspecting_runs_nothing(tmp_path):
    proof = tmp_path / "ran"
    inspection = inspect(f"open({str(proof)!r}, 'w').close()\ndef f(): pass".encode())
    assert inspection.defines("f")
    assert not inspection.defines("g")
    assert not proof.exists()


def test_a_syntax_error_has_its_place_and_an_empty_source_none():
    assert (inspect(b"").fault, inspect(b"").names) == (None, ())
    fault = inspect(b"x = 1\ndef f(:\n    pass\n").fault
    assert fault.message == "SyntaxError: invalid syntax"
    assert (fault.line, fault.text) == (2, "def f(:")


@on_linux
@pytest.mark.parametrize("level", LEVELS)
def test_nothing_is_left_when_a_box_closes(level, tmp_path, monkeypatch):
    require(level)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    descriptors, processes = len(list(Path("/dev/fd").iterdir())), children()
    with open_box(b"def f(): return 1", "my.py", level=level) as box:
        assert box.call("f", [()], LIMITS).replies[0].answer == 1
        assert box.run_program(b"", LIMITS).detail == ""
        assert children() > processes
        assert sum(map(len, (names for _, _, names in os.walk(tmp_path)))) == 0  # an empty home at most
    assert children() == processes
    assert len(list(Path("/dev/fd").iterdir())) == descriptors
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("python", "what"),
    [
        ("/nowhere/python", "no container can be started: "),
        ("/bin/false", "no container could be started: it ended without a word"),  # which may pass
    ],
)
def test_an_interpreter_that_does_not_start_is_one_clear_error(python, what, monkeypatch):
    before = children()
    monkeypatch.setattr(sys, "executable", python)
    monkeypatch.setattr(levels, "PAUSES", (0.0,) * len(levels.PAUSES))
    with pytest.raises(JudgeError) as caught, open_box(b"", "my.py"):
        pass
    assert caught.value.what.startswith(what)
    assert "\n" not in caught.value.what
    assert children() == before


GOOD = b"[0,1],\n"
NO_NOTE = (wire.NO_NOTE, "")
TIGHT = limits(cpu_seconds=1.0, memory_bytes=1 << 20, output_bytes=100)


def done(status=0, reason=wire.NOT_KILLED, cpu=0.0, peak=0):
    return ChildEnd(status, reason, round(cpu * 1e9), 0, peak, 1)


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
        # what was measured comes before what the child says; filling memory takes time, and so does printing
        (done(signal.SIGKILL, wire.FOR_CPU, cpu=2.0, peak=2 << 20), 100, NO_NOTE, Stop.MEMORY),
        (done(signal.SIGKILL, wire.FOR_CPU), 100, (wire.NO_MEMORY, ""), Stop.CPU),
        (done(signal.SIGKILL, wire.FOR_CPU, cpu=2.0, peak=2 << 20), 101, (wire.NO_MEMORY, ""), Stop.OUTPUT),
    ],
)
def test_the_limit_that_was_passed(ended, printed, note, stop):
    found = overrun(ended._replace(note=note), TIGHT, printed)
    assert (found and found[0]) == stop


@pytest.mark.parametrize(
    ("status", "note", "end"),
    [
        (0, NO_NOTE, (Stop.ANSWERED, "exit status 0")),
        (7 << 8, NO_NOTE, (Stop.EXITED, "exit status 7")),
        (1 << 8, (wire.RAISED, "E (line 1)"), (Stop.EXCEPTION, "E (line 1)")),
        (signal.SIGKILL, NO_NOTE, (Stop.EXITED, "killed by SIGKILL")),
        (signal.SIGSEGV, NO_NOTE, (Stop.EXITED, "killed by SIGSEGV (did it call itself too deeply?)")),
        (45, NO_NOTE, (Stop.EXITED, "killed by signal 45")),
    ],
)
def test_the_end_of_a_child_within_its_limits(status, note, end):
    assert end_of(done(int(status))._replace(note=note)) == end
