"""Several series of calls in one process: none can take the time, or know the arguments, of another."""

from __future__ import annotations

import struct
import sys
from collections.abc import Sequence

import pytest
from forger import source

from judge.sandbox import CallsResult, Limits, Stop, open_box

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="a process for each series elsewhere")

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=100_000)
SERIES = [[(1,), (2,)], [(3,)], [(4,), (5,)]]
ANSWERS = [[1, 2], [3], [4, 5]]


def _run(
    deed: str,
    level: str,
    limits: Limits = LIMITS,
    at: int = 1,
    series: Sequence[Sequence[tuple[object, ...]]] = SERIES,
) -> list[CallsResult]:
    with open_box(source(deed, at), "f.py", level=level) as box:
        return box.call_series("f", series, limits)


def _answers(results: Sequence[CallsResult]) -> list[list[object]]:
    return [[reply.answer for reply in result.replies] for result in results]


@pytest.mark.parametrize("before", ["", r"forge(b'[0,1],\n')", r"forge(b'[0,1],\n' * 3)", "forge(b'x' * 14)"])
def test_a_stop_that_ends_no_series_gives_no_time(level: str, before: str) -> None:
    deed = f"for _ in range(9):\n    spin(0.2)\n    {before or 'pass'}\n    stop()"
    results = _run(deed, level, LIMITS._replace(cpu_seconds=0.5))
    assert len(results) == 1
    assert results[0].replies[-1].stop in {Stop.EXITED, Stop.TAMPERED}
    assert results[0].usage.cpu_seconds < 0.5


def test_a_program_that_stops_itself_is_not_waited_for(level: str) -> None:
    with open_box(b"import os\nos.kill(os.getpid(), 19)\n", "f.py", level=level) as box:
        result = box.run_program(b"", LIMITS)
        assert (result.stop, result.detail) == (Stop.EXITED, "stopped itself")


@pytest.mark.parametrize("late", [r"[0,1],\n[0,2],\n", r"[0,2],\n[0,1],\n"])
def test_answers_are_sealed_at_the_end_of_their_series(level: str, late: str) -> None:
    """Forged ones end the series early, so that the right ones can be found on the time of the next."""
    deed = rf"""
at = forge(b'[0,7],\n[0,7],\n')
stop()
forge(b'{late}', at)
forge(b'[0,3],\n[0,4],\n[0,5],\n', at + 14)
os._exit(0)
"""
    (first,) = _run(deed, level)
    assert [reply.stop for reply in first.replies] == [Stop.TAMPERED]


def test_an_answer_cannot_reach_over_the_end_of_its_series(level: str) -> None:
    deed = r"""
at = forge(b'[0,1],\n[0,\n')
stop()
forge(b'2],[0,3],[0,4],[0,5],\n', at + 11)
os._exit(0)
"""
    (first,) = _run(deed, level)
    assert [reply.stop for reply in first.replies] == [Stop.ANSWERED, Stop.TAMPERED]


def test_nothing_is_answered_before_it_is_asked(level: str) -> None:
    (first,) = _run(r"forge(b'[0,1],\n[0,2],\n[0,3],\n[0,4],\n[0,5],\n'); os._exit(0)", level)
    assert [reply.stop for reply in first.replies] == [Stop.ANSWERED, Stop.TAMPERED]


@pytest.mark.parametrize("place", [0, 1, 2])
def test_later_arguments_are_not_there_yet(level: str, place: int) -> None:
    """All that it could find them in is the region, which is searched from its beginning to its end."""
    secret = 1234.5678
    needle = struct.pack("<d", secret)
    deed = f"""
frame = sys._getframe()
while 'region' not in frame.f_locals:
    frame = frame.f_back
memory = frame.f_locals['region'].memory
return memory.find(bytes(255 - b for b in {bytes(255 - b for b in needle)!r})) >= 0
"""
    series: list[list[tuple[object, ...]]] = [[(1, 0.0)], [(1, 0.0)], [(1, 0.0)]]
    series[place] = [(1, secret)]
    found = _run(deed, level, series=series)
    seen = [answer[0]["text"] == "True" for answer in _answers(found)]  # type: ignore[index]
    assert seen[: place + 1] == [False] * place + [True]


def test_the_file_of_the_arguments_is_not_open_in_the_child(level: str) -> None:
    deed = """
opened = []
for number in range(3, 64):
    try:
        os.fstat(number)
        if number != 4 or not os.pread(4, 99, 0).startswith(b'\\nimport os, signal'):  # its own source
            opened.append(number)
    except OSError:
        pass
return opened
"""
    assert _answers(_run(deed, level)) == [[[], 2], *ANSWERS[1:]]


def test_waiting_is_counted_over_all_series(level: str) -> None:
    given = b"import time\ndef f(x):\n    time.sleep(0.3)\n    return x\n"
    with open_box(given, "f.py", level=level) as box:
        results = box.call_series("f", [[(n,)] for n in range(9)], LIMITS._replace(waiting_seconds=0.75))
    assert 1 < len(results) < 4  # fewer on a busy machine, where it waits for the processor too
    assert results[-1].replies[-1].stop is Stop.WAITING
    assert sum(result.usage.waiting_seconds for result in results) >= 0.74


def test_work_is_not_waiting(level: str) -> None:
    """The wait it does here is for the processor of a busy machine."""
    results = _run("spin(0.5)", level, LIMITS._replace(waiting_seconds=5.0))
    assert _answers(results) == ANSWERS


@pytest.mark.parametrize("stream", [1, 2])
def test_the_output_limit_is_each_series_own(level: str, stream: int) -> None:
    given = f"import os\ndef f(x):\n    os.write({stream}, b'x' * 80_000)\n    return x\n"
    with open_box(given.encode(), "f.py", level=level) as box:
        assert _answers(box.call_series("f", [[(n,)] for n in range(5)], LIMITS)) == [[n] for n in range(5)]
        twice = box.call_series("f", [[(1,)], [(2,), (3,)]], LIMITS)
    assert [result.replies[-1].stop for result in twice][:1] == [Stop.ANSWERED]
    assert {reply.stop for reply in twice[1].replies} <= {Stop.ANSWERED, Stop.EXCEPTION, Stop.OUTPUT}
    assert twice[1].replies[-1].stop is Stop.OUTPUT


@pytest.mark.parametrize(("at", "series"), [(1, 1), (3, 2), (5, 3)])
def test_a_flood_that_goes_on_as_if_nothing_were_is_noticed_in_its_series(
    level: str, at: int, series: int
) -> None:
    deed = "try:\n    while True: os.write(1, b'x' * 4096)\nexcept OSError: pass"
    results = _run(deed, level, at=at)
    assert len(results) == series
    assert results[-1].replies[-1].stop is Stop.OUTPUT


def test_answers_have_the_limit_for_each_series_and_end_the_process_where_there_is_no_room(
    level: str,
) -> None:
    given = b"def f(x):\n    return ['x' * 80] * 800\n"  # about 83,000 bytes
    with open_box(given, "f.py", level=level) as box:
        results = box.call_series("f", [[(n,)] for n in range(5)], LIMITS)
        assert [[reply.stop for reply in result.replies] for result in results] == [[Stop.ANSWERED]] * 2
        (both,) = box.call_series("f", [[(1,), (2,)]], LIMITS)
        assert both.replies[-1].stop is Stop.OUTPUT
