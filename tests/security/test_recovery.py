"""A call that dies, hangs, floods, closes its descriptors or lies costs exactly itself."""

from __future__ import annotations

import pytest
from attackers import LEVELS, by_turns
from forger import source

from judge.sandbox import container, open_box
from judge.sandbox.boundary import Limits, Reply, Stop
from judge.sandbox.box import PythonBox

LIMITS = Limits(cpu_seconds=0.3, wall_seconds=1.5, memory_bytes=128 << 20, output_bytes=200_000)

DEEDS = {
    "leaves": ("os._exit(0)", {Stop.EXITED}),
    "leaves_with_a_status": ("os._exit(7)", {Stop.EXITED}),
    "kills_itself": ("os.kill(os.getpid(), 9)", {Stop.EXITED}),
    "crashes": ("import ctypes; ctypes.string_at(0)", {Stop.EXITED}),
    "works_on": ("while True: pass", {Stop.CPU, Stop.WALL}),
    "sleeps": ("time.sleep(60)", {Stop.WALL}),
    "stops": ("os.kill(os.getpid(), signal.SIGSTOP)", {Stop.EXITED}),
    "hogs": ("rows = []\nwhile True: rows.append(bytearray(b'x') * (8 << 20))", {Stop.MEMORY, Stop.CPU}),
    "runs_out_of_memory": ("return [0] * (1 << 33)", {Stop.MEMORY}),
    "answers_a_flood": ("return ['x' * 80] * 9000", {Stop.OUTPUT}),
    "prints_a_flood": (
        "\n".join(["try:", "  while True: os.write(1, b'x' * 4096)", "except OSError: os._exit(0)"]),
        {Stop.OUTPUT},
    ),
    "closes_everything_and_leaves": ("os.closerange(0, 99); os._exit(0)", {Stop.EXITED}),
    "leaves_with_a_thread": (
        "threading.Thread(target=os._exit, args=(3,)).start(); time.sleep(9)",
        {Stop.EXITED},
    ),
    "writes_into_its_replies": (r"forge(b'junk\n'); os._exit(0)", {Stop.TAMPERED}),
    "moves_the_mark_far_away": ("replies()['words'][0] = 2**63; os._exit(0)", {Stop.TAMPERED}),
    "answers_what_json_is_not": (r"forge(b'[0,NaN],\n'); os._exit(0)", {Stop.TAMPERED}),
    "answers_what_no_reply_is": (r"forge(b'{\"a\":1},\n'); os._exit(0)", {Stop.TAMPERED}),
    "answers_deeply": ("forge(b'[' * 50_000); os._exit(0)", {Stop.TAMPERED}),
}
HARMLESS = {
    "raises": "1 / 0",
    "exits": "sys.exit(3)",
    "interrupts": "raise KeyboardInterrupt",
    "raises_what_cannot_be_shown": "raise Mute",
    "recurses": "def deeper(): return deeper()\nreturn deeper()",  # 3.13.0 does not count calls with *more
}


def _box(deed: str, level: str) -> PythonBox:
    return open_box(source(deed, at=2), "f.py", level=level)


def _all_calls(box: PythonBox, count: int) -> tuple[list[Reply], int]:
    """Every call, going on after each end of a series; and how many series that took."""
    replies: list[Reply] = []
    series = 0
    while len(replies) < count:
        series += 1
        assert series <= count
        replies += box.call("f", [[number] for number in range(len(replies), count)], LIMITS).replies
    return replies, series


@pytest.mark.parametrize(("deed", "level"), by_turns(DEEDS, LEVELS), indirect=["level"])
def test_exactly_one_call_is_lost(level: str, deed: str) -> None:
    code, stops = DEEDS[deed]
    with _box(code, level) as box:
        replies, series = _all_calls(box, 5)
        assert len(replies) == 5
        assert replies[2].stop in stops, replies[2]
        assert [replies[place].answer for place in (0, 1, 3, 4)] == [0, 1, 3, 4]
        assert series == 2
        assert replies[2].detail.isprintable()


@pytest.mark.parametrize(("deed", "level"), by_turns(HARMLESS, LEVELS), indirect=["level"])
def test_an_exception_does_not_end_the_series(level: str, deed: str) -> None:
    with _box(HARMLESS[deed], level) as box:
        replies, series = _all_calls(box, 5)
        assert series == 1
        assert replies[2].stop is Stop.EXCEPTION
        assert [replies[place].answer for place in (0, 1, 3, 4)] == [0, 1, 3, 4]


@pytest.mark.parametrize("number", ["SIGKILL", "SIGSTOP"])
def test_a_call_that_ends_or_stops_its_watcher_costs_only_itself(
    level: str, number: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(container, "GRACE_SECONDS", 0.5)
    with _box(f"os.kill(os.getppid(), signal.{number}); time.sleep(5)", level) as box:
        replies, _ = _all_calls(box, 5)
        assert replies[2].stop is (Stop.TAMPERED if level == "limits" else Stop.EXCEPTION)
        assert [replies[place].answer for place in (0, 1, 3, 4)] == [0, 1, 3, 4]


def test_a_forged_note_is_no_fault_of_the_judge(level: str) -> None:
    deed = "region = sys._getframe(1).f_locals['region']\nregion.write_note(4, 'broken')\nos._exit(99)"
    with _box(deed, level) as box:
        replies, series = _all_calls(box, 4)
        assert (replies[2].stop, series) == (Stop.EXITED, 2)


def test_replies_that_come_early_are_its_own_answers_and_more_than_calls_are_tampering(level: str) -> None:
    calls = [[2], [3], [4]]
    with _box(r"forge(b'[0,7],\n' * 3); os._exit(0)", level) as box:
        replies = box.call("f", calls, LIMITS).replies
        assert [(reply.stop, reply.answer) for reply in replies] == [(Stop.ANSWERED, 7)] * 3
    with _box(r"forge(b'[0,7],\n' * 9); os._exit(0)", level) as box:
        replies = box.call("f", calls, LIMITS).replies
        assert (len(replies), replies[-1].stop) == (3, Stop.TAMPERED)


@pytest.mark.parametrize("answer", ["[[]]", "x = []; x.append(x)", "x = 0\nfor _ in range(99999): x = [x]"])
def test_deep_and_cyclic_answers_come_back_as_something(level: str, answer: str) -> None:
    deed = answer if "x" in answer else f"x = {answer}"
    with _box(f"{deed}\nreturn x", level) as box:
        replies, _ = _all_calls(box, 4)
        assert [replies[place].answer for place in (0, 1, 3)] == [0, 1, 3]
        assert replies[2].stop in {Stop.ANSWERED, Stop.EXCEPTION}


def test_the_last_call_of_a_series_can_be_the_one(level: str) -> None:
    with _box("os._exit(0)", level) as box:
        result = box.call("f", [[0], [1], [2]], LIMITS)
        assert [reply.stop for reply in result.replies] == [Stop.ANSWERED, Stop.ANSWERED, Stop.EXITED]


def test_a_module_that_raises_fails_every_call_once(level: str) -> None:
    with open_box(b"x = 1\nraise ValueError('no')\ndef f(x): return x\n", "f.py", level=level) as box:
        replies = box.call("f", [[0], [1]], LIMITS).replies
        assert [reply.detail for reply in replies] == [
            "ValueError: no (line 2), while the module was imported"
        ] * 2


def test_a_module_that_leaves_ends_the_series(level: str) -> None:
    with open_box(b"import os\nos._exit(0)\ndef f(x): return x\n", "f.py", level=level) as box:
        (reply,) = box.call("f", [[0], [1]], LIMITS).replies
        assert reply.stop is Stop.EXITED
        assert "while the module was imported" in reply.detail


def test_arguments_are_fresh_and_sequences_are_what_they_were(level: str) -> None:
    given = b"def f(a, p):\n    return [type(p).__name__, p[0] is a, p[1]]\n"
    with open_box(given, "f.py", level=level) as box:
        replies = box.call("f", [[1.5, [1, 2.5]], [2**200, (1, -0.0)]], LIMITS).replies
        assert [reply.answer[2] for reply in replies] == [2.5, -0.0]
        assert [reply.answer[0] for reply in replies] == [{"word": "list"}, {"word": "tuple"}]


@pytest.mark.parametrize(
    ("broken", "line"),
    [
        (b"def f(:\n", 1),
        (b"x = 1\nx = 'a\n", 2),
        (b"a\x00b", 0),
        (b"\xff\xfe", 0),
        (b"(" * 5000 + b")" * 5000, 0),
        (b"x = " + b"-" * 200_000 + b"1", 0),
        (b"x = " + b"+".join([b"1"] * 60_000), 0),
    ],
)
def test_a_source_that_breaks_the_compiler_is_a_fault(level: str, broken: bytes, line: int) -> None:
    with open_box(broken, "f.py", level=level) as box:
        fault = box.inspect().fault
        assert fault is not None
        assert fault.message
        assert not line or fault.line == line
        assert box.run_program(b"", LIMITS).stop is Stop.EXCEPTION
