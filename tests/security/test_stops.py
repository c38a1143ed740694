"""Import and calls are measured apart: no stop gives time, no argument is there before it is asked for."""

from __future__ import annotations

import struct
import sys
from collections.abc import Sequence

import pytest
from forger import source

from judge.sandbox import Limits, Stop, open_box
from judge.sandbox.boundary import CallsResult

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="no process is stopped elsewhere")

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=100_000)
CALLS = [(1,), (2,), (3,), (4,), (5,)]
AT_IMPORT = """
frame = sys._getframe()
while 'region' not in frame.f_locals:
    frame = frame.f_back
region = frame.f_locals['region']
def claim(data):
    at = region.words[0]
    region.memory[at : at + len(data)] = data
    region.words[0] = at + len(data)
"""


def _run(
    deed: str,
    level: str,
    limits: Limits = LIMITS,
    *,
    at_import: str = "",
    calls: Sequence[tuple[object, ...]] = CALLS,
) -> CallsResult:
    more = f"{AT_IMPORT}{at_import}\n".encode() if at_import else b""
    with open_box(source(deed, 1) + more, "f.py", level=level) as box:
        return box.call("f", calls, limits)


def _answers(result: CallsResult) -> list[object]:
    return [reply.answer for reply in result.replies]


@pytest.mark.parametrize("before", ["", r"forge(b'[0,1],\n')", r"forge(b'[0,1],\n' * 3)", "forge(b'x' * 14)"])
def test_a_stop_of_its_own_gives_no_time(level: str, before: str) -> None:
    deed = f"for _ in range(9):\n    spin(0.2)\n    {before or 'pass'}\n    stop()"
    result = _run(deed, level, LIMITS._replace(cpu_seconds=0.5))
    assert result.replies[-1].stop in {Stop.EXITED, Stop.TAMPERED}
    assert len(result.replies) < len(CALLS)
    assert result.usage.cpu_seconds < 0.5


def test_a_program_that_stops_itself_is_not_waited_for(level: str) -> None:
    with open_box(b"import os\nos.kill(os.getpid(), 19)\n", "f.py", level=level) as box:
        result = box.run_program(b"", LIMITS)
        assert (result.stop, result.detail) == (Stop.EXITED, "stopped itself")


def test_a_stop_of_its_own_in_the_import_leads_nowhere(level: str) -> None:
    """The rest of the import is on the time of the calls, and its true end is taken for theirs."""
    result = _run("pass", level, at_import="stop()\nspin(0.3)")
    assert [(reply.stop, reply.detail) for reply in result.replies] == [(Stop.EXITED, "stopped itself")]
    assert result.usage.cpu_seconds > 0.29


@pytest.mark.parametrize("then", ["pass", "stop()", "os._exit(0)"])
@pytest.mark.parametrize("claimed", [1, 5])
def test_nothing_is_answered_before_it_is_asked(level: str, then: str, claimed: int) -> None:
    result = _run("pass", level, at_import=f"claim(b'[0,1],\\n' * {claimed})\n{then}")
    assert [reply.stop for reply in result.replies] == [Stop.TAMPERED]


def test_no_argument_is_there_during_the_import(level: str) -> None:
    """All that it could find them in is the region, which is searched from its beginning to its end."""
    secret = 1234.5678
    needle = struct.pack("<d", secret)
    search = f"seen = region.memory.find(bytes(255 - b for b in {bytes(255 - b for b in needle)!r})) >= 0"
    result = _run("return int(seen), int(region.memory.find(bytes(8)) >= 0)", level, at_import=search)
    assert _answers(result)[0] == [0, 1]
    later = search.replace("seen =", "return int(").removesuffix(" >= 0") + " >= 0)"
    found = _run(later, level, at_import="pass", calls=[(1, secret)])
    assert _answers(found) == [1], "the search finds what is there"


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
    assert _answers(_run(deed, level)) == [[], 2, 3, 4, 5]


@pytest.mark.parametrize(
    ("at_import", "deed"), [("time.sleep(0.5)", "time.sleep(0.5)"), ("", "time.sleep(1)")]
)
def test_waiting_is_counted_over_import_and_calls(level: str, at_import: str, deed: str) -> None:
    result = _run(deed, level, LIMITS._replace(waiting_seconds=0.75), at_import=at_import)
    assert [reply.stop for reply in result.replies] == [Stop.WAITING]
    assert (result.usage + result.imported).waiting_seconds >= 0.74


def test_work_is_not_waiting(level: str) -> None:
    """The wait it does here is for the processor of a busy machine."""
    result = _run("spin(0.5)", level, LIMITS._replace(waiting_seconds=5.0))
    assert _answers(result) == [1, 2, 3, 4, 5]


def test_import_and_calls_have_the_time_limit_each_and_nothing_else_is_charged(level: str) -> None:
    both = LIMITS._replace(cpu_seconds=1.0)
    table = "table = dict.fromkeys(range(1 << 20))\nspin(0.6)"  # to be given back at the end
    result = _run("spin(0.6)", level, both, at_import=table)
    assert _answers(result) == [1, 2, 3, 4, 5]
    assert 0.59 < result.usage.cpu_seconds < 1
    assert 0.59 < result.imported.cpu_seconds < 1
    for at_import, deed in (("spin(1.4)", "pass"), ("pass", "spin(1.4)")):
        late = _run(deed, level, both, at_import=at_import)
        assert [reply.stop for reply in late.replies] == [Stop.CPU]
        assert late.usage.cpu_seconds > 0.99


def test_what_gives_its_memory_back_is_charged_to_no_call(level: str) -> None:
    result = _run("pass", level, at_import="table = bytearray(b'x') * (192 << 20)")
    assert _answers(result) == [1, 2, 3, 4, 5]
    assert result.usage.cpu_seconds < 0.01


def test_a_thread_that_works_at_a_stop_works_on_the_time_of_the_calls(level: str) -> None:
    begun = "threading.Thread(target=spin, args=(0.4,)).start()"
    result = _run("threading.enumerate()[-1].join()", level, at_import=begun)
    assert (result.usage + result.imported).cpu_seconds > 0.38


@pytest.mark.parametrize("stream", [1, 2])
def test_a_flood_that_goes_on_as_if_nothing_were_is_noticed(level: str, stream: int) -> None:
    deed = f"try:\n    while True: os.write({stream}, b'x' * 4096)\nexcept OSError: pass"
    result = _run(deed, level)
    assert result.replies[-1].stop is Stop.OUTPUT


def test_answers_that_are_too_long_together_end_the_process(level: str) -> None:
    given = b"def f(x):\n    return ['x' * 80] * 800\n"  # about 83,000 bytes
    with open_box(given, "f.py", level=level) as box:
        result = box.call("f", [(1,), (2,), (3,)], LIMITS)
    assert [reply.stop for reply in result.replies] == [Stop.ANSWERED, Stop.OUTPUT]
