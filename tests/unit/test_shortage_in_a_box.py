"""What the machine does to a submission is never taken for its own doing."""

from __future__ import annotations

import errno
import os
import signal
import tempfile

import pytest
from sandboxed import LIMITS, children, require

from judge.errors import JudgeError, ShortageError, shortage, told
from judge.sandbox import Stop, open_box, room
from judge.sandbox.box import ForkServerBox
from judge.sandbox.inside import wire

pytestmark = pytest.mark.slow

SELF_KILLED = b"import os\ndef f(n):\n    if n == 1: os.kill(os.getpid(), 9)\n    return n\n"


@pytest.mark.parametrize("level", ["full", "strong"])
def test_a_kill_for_want_of_memory_is_a_shortage_and_any_other_is_not(level, monkeypatch):
    require(level)
    with open_box(SELF_KILLED, "f.py", level=level) as box:
        calls = [(0,), (1,), (2,)]
        assert box.call_many("f", calls, LIMITS).replies[-1].stop is Stop.EXITED
        before = room.oom_kills()
        monkeypatch.setattr(room, "oom_kills", lambda: before + 1)
        with pytest.raises(ShortageError, match="killed the submission's process: there is no memory left"):
            box.call_many("f", calls, LIMITS)
        assert box.call_many("f", calls[:1], LIMITS).replies[0].answer == 0
    with open_box(b"import os; os.kill(os.getpid(), 9)", "f.py", level=level) as box:
        monkeypatch.undo()
        monkeypatch.setattr(room, "oom_kills", lambda: before + 2)
        with pytest.raises(ShortageError):
            box.run_program(b"", LIMITS)


@pytest.mark.parametrize("reason", [wire.FOR_WALL, wire.FOR_CPU])
def test_a_compiler_that_is_kept_waiting_or_killed_is_no_compile_error(reason, monkeypatch):
    """One that takes all its time is."""
    real = ForkServerBox._ask

    def disturbed(self, kind, *arguments):
        done = real(self, kind, *arguments)
        return done._replace(status=int(signal.SIGKILL), reason=reason) if kind == wire.INSPECT else done

    monkeypatch.setattr(ForkServerBox, "_ask", disturbed)
    with open_box(b"def f(n): return n", "f.py") as box:
        if reason == wire.FOR_CPU:
            assert "the compiler did not survive it: used more than 10 s" in box.inspect().fault.message
            return
        with pytest.raises(ShortageError, match="judge it again, with a smaller -j if the machine is busy"):
            box.inspect()
        monkeypatch.undo()
        assert box.inspect().fault is None


def test_on_linux_no_temporary_file_is_needed(monkeypatch):
    def full(*_arguments, **_settings):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    for name in ("mkstemp", "TemporaryFile", "NamedTemporaryFile", "mkdtemp"):
        monkeypatch.setattr(tempfile, name, full)
    require("strong")
    before = children()
    with open_box(b"def f(n): return n", "f.py") as box:
        assert box.call_many("f", [(1,)], LIMITS).replies[0].answer == 1
        assert box.run_program(b"", LIMITS).stop is Stop.ANSWERED
    assert children() == before


@pytest.mark.parametrize(
    ("fault", "line"),
    [
        (OSError(errno.EMFILE, "x"), "the judge has no file descriptor left; use a smaller -j, or raise the"),
        (MemoryError(), "there is no memory left; use a smaller -j, end other programs, or raise the limit"),
        (RuntimeError("can't start new thread"), "no further process or thread can be started; use"),
        (OSError(errno.ENOSPC, "x"), "there is no space left for a file; free some"),
        (JudgeError("it broke", remedy="mend it"), "it broke; mend it"),
        (RuntimeError("it broke"), "internal fault: RuntimeError('it broke')"),
        (OSError(errno.EPERM, "no"), "internal fault: PermissionError(1, 'no')"),
    ],
)
def test_a_fault_is_told_as_the_shortage_it_is(fault, line):
    assert told(fault).startswith(line)
    assert isinstance(shortage(fault), ShortageError) is ("internal" not in line and "broke" not in line)
