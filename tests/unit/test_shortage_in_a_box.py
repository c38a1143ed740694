"""What the machine does to a submission, or lacks, is never taken for its own doing."""

from __future__ import annotations

import errno
import os
import resource
import signal
import tempfile

import pytest
from native import box_of
from sandboxed import LIMITS, children, require

from judge.errors import JudgeError, ShortageError, shortage, told
from judge.sandbox import Containment, Stop, open_box, room
from judge.sandbox import box as box_
from judge.sandbox import compile as compile_
from judge.sandbox.box import PythonBox
from judge.sandbox.container import Container
from judge.sandbox.inside import wire
from judge.sandbox.native import NativeBox
from judge.sandbox.room import BASE_FILES, BASE_TASKS, OWN_FILES, OWN_TASKS, SLACK, THREADS, Room

pytestmark = pytest.mark.slow

SELF_KILLED = b"import os\ndef f(n):\n    if n == 1: os.kill(os.getpid(), 9)\n    return n\n"


@pytest.mark.parametrize("level", ["full", "strong"])
def test_a_kill_for_want_of_memory_is_a_shortage_and_any_other_is_not(level, monkeypatch):
    require(level)
    with open_box(SELF_KILLED, "f.py", level=level) as box:
        calls = [(0,), (1,), (2,)]
        assert box.call("f", calls, LIMITS).replies[-1].stop is Stop.EXITED
        before = room.oom_kills()
        monkeypatch.setattr(room, "oom_kills", lambda: before + 1)
        with pytest.raises(ShortageError, match="killed the submission's process: there is no memory left"):
            box.call("f", calls, LIMITS)
        assert box.call("f", calls[:1], LIMITS).replies[0].answer == 0
    with open_box(b"import os; os.kill(os.getpid(), 9)", "f.py", level=level) as box:
        monkeypatch.undo()
        monkeypatch.setattr(room, "oom_kills", lambda: before + 2)
        with pytest.raises(ShortageError):
            box.run_program(b"", LIMITS)


@pytest.mark.parametrize(
    ("reason", "end"),
    [
        (wire.FOR_WALL, signal.SIGKILL),
        (wire.NOT_KILLED, signal.SIGTERM),
        (wire.FOR_CPU, signal.SIGKILL),
        (wire.NOT_KILLED, signal.SIGSEGV),
    ],
)
def test_a_compiler_that_is_kept_waiting_or_killed_is_no_compile_error(reason, end, monkeypatch):
    """One that takes all its time is, and one that breaks."""
    real = PythonBox._ask

    def disturbed(self, kind, *arguments):
        done = real(self, kind, *arguments)
        return done._replace(status=int(end), reason=reason) if kind == wire.INSPECT else done

    monkeypatch.setattr(PythonBox, "_ask", disturbed)
    with open_box(b"def f(n): return n", "f.py") as box:
        if reason == wire.FOR_CPU or end == signal.SIGSEGV:
            why = "killed by SIGSEGV" if end == signal.SIGSEGV else "used more than 10 s"
            assert f"the compiler did not survive it: {why}" in box.inspect().fault.message
            return
        with pytest.raises(ShortageError, match="judge it again, with a smaller -j if the machine is busy"):
            box.inspect()
        monkeypatch.undo()
        assert box.inspect().fault is None


def test_a_long_source_that_a_busy_machine_compiles_too_late_is_no_compile_error(monkeypatch):
    source = b"x = 1\n" * 50_000 + b"def f(n):\n    return n"
    monkeypatch.setattr(box_, "_INSPECTION", box_._INSPECTION._replace(wall_seconds=0.01))
    with open_box(source, "f.py") as box, pytest.raises(ShortageError, match="too busy to compile it"):
        box.inspect()
    monkeypatch.undo()
    with open_box(source, "f.py") as box:
        assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1


C = "int main(void) { return 0; }"


@pytest.fixture(autouse=True)
def _nothing_compiled_before(monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))


def test_a_compiler_that_waits_for_the_processor_is_no_compile_error(monkeypatch):
    monkeypatch.setattr(compile_, "LIMITS", compile_.LIMITS._replace(wall_seconds=0.003))
    with box_of("a.c", C) as box, pytest.raises(ShortageError, match="too busy to compile it: that took"):
        box.inspect()


def ended(monkeypatch, **more):
    """What a compiler that ends so comes to."""
    real = Container.ask

    def disturbed(self, kind, *arguments):
        done = real(self, kind, *arguments)
        return done._replace(**more) if kind == wire.EXECUTE else done

    monkeypatch.setattr(Container, "ask", disturbed)
    with box_of("a.c", C) as box:
        return box.inspect().fault.message


@pytest.mark.parametrize(
    ("reason", "status", "why"),
    [
        (wire.FOR_WALL, signal.SIGKILL, "the machine is too busy to compile it"),
        (wire.NOT_KILLED, signal.SIGKILL, "the compiler was killed"),
        (wire.NOT_KILLED, signal.SIGTERM, "the compiler was killed"),
        (wire.NOT_KILLED, 1 << 8, "the empty C program fails"),
    ],
)
def test_an_end_of_the_compiler_that_the_machine_brought_about_is_a_shortage(
    reason, status, why, monkeypatch
):
    with pytest.raises(ShortageError, match=why):
        ended(monkeypatch, reason=reason, status=int(status))


def test_a_compiler_that_is_killed_for_want_of_memory_is_a_shortage(monkeypatch):
    kills = iter(range(9))
    monkeypatch.setattr(room, "oom_kills", lambda: next(kills))
    with pytest.raises(ShortageError, match="the kernel has killed the compiler: there is no memory left"):
        ended(monkeypatch, status=1 << 8)


@pytest.mark.parametrize("more", [{"reason": wire.FOR_CPU}, {"cpu_ns": 11 * 10**9}])
def test_a_compiler_that_takes_all_its_time_is_a_compile_error(more, monkeypatch):
    monkeypatch.setattr(NativeBox, "_compiled", once(NativeBox._compiled, ((), None)))
    assert "more than 10 s of CPU time" in ended(monkeypatch, status=int(signal.SIGKILL), **more)


def once(act, later):
    """What acts at its first call alone."""
    left = [act]
    return lambda *arguments: left.pop()(*arguments) if left else later


END = "#include <signal.h>\n#include <unistd.h>\nint main(void) {{ kill({}, 9); pause(); }}"


def test_the_kernel_kills_a_compiled_program_too(monkeypatch):
    with box_of("a.c", END.format("getpid()")) as box:
        assert box.run_program(b"", LIMITS).stop is Stop.EXITED
        before = room.oom_kills()
        monkeypatch.setattr(room, "oom_kills", lambda: before + 1)
        with pytest.raises(ShortageError, match="killed the submission's process: there is no memory left"):
            box.run_program(b"", LIMITS)


def test_a_compiled_program_that_ends_what_watches_it_is_no_shortage():
    """Nothing hinders it where there are resource limits alone."""
    with box_of("a.c", END.format("getppid()"), level="limits") as box:
        assert box.run_program(b"", LIMITS).stop is Stop.TAMPERED
        assert box.run_program(b"", LIMITS).stop is Stop.TAMPERED


@pytest.mark.parametrize("each", [room.THREADS, 70])
def test_no_word_of_a_submission_is_believed_about_the_machine(each):
    source = b"def f(n): raise RuntimeError(\"can't start new thread\")\nif __name__ == '__main__': f(1)"
    with Containment(share=room.Share(each=each))(source, "f.py") as box:
        (reply,) = box.call("f", [(1,)], LIMITS).replies
        run = box.run_program(b"", LIMITS)
    assert (reply.stop, run.stop) == (Stop.EXCEPTION, Stop.EXCEPTION)
    for detail in (reply.detail, run.detail):
        assert "RuntimeError: can't start new thread" in detail
        assert ("it may have 70 threads at once here, and not 128 as elsewhere" in detail) is (each == 70)


def test_on_linux_no_temporary_file_is_needed(monkeypatch):
    def full(*_arguments, **_settings):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    for name in ("mkstemp", "TemporaryFile", "NamedTemporaryFile", "mkdtemp"):
        monkeypatch.setattr(tempfile, name, full)
    require("strong")
    before = children()
    with open_box(b"def f(n): return n", "f.py") as box:
        assert box.call("f", [(1,)], LIMITS).replies[0].answer == 1
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


PLENTY = 1 << 30


def a_room(tasks=PLENTY, files=PLENTY, ceiling=PLENTY):
    return Room(tasks, "tasks!", ceiling, files, "files!")


@pytest.mark.parametrize("jobs", [1, 2, 7, 256])
def test_what_is_done_at_once_has_room_together(jobs):
    plenty = a_room().share(jobs)
    assert a_room().at_once(jobs) == (jobs, "")
    assert (plenty.each, plenty.together, plenty.short) == (THREADS, jobs * THREADS + SLACK, False)
    enough = a_room(tasks=BASE_TASKS + jobs * (OWN_TASKS + THREADS))
    assert (enough.at_once(jobs), enough.share(jobs).each) == ((jobs, ""), THREADS)
    less = enough._replace(tasks=enough.tasks - 1)
    assert less.at_once(jobs) == (max(1, jobs - 1), "" if jobs == 1 else "tasks!")
    for left in range(0, 3000, 37):
        some = a_room(tasks=left)
        count, _ = some.at_once(jobs)
        share = some.share(count)
        used = BASE_TASKS + count * (OWN_TASKS + share.each)
        assert used <= left or (count, share.each) == (1, room.LEAST_THREADS)
        assert share.short is (share.each < THREADS)
        assert not share.short or count == 1


def test_the_scarcer_of_two_things_is_named():
    files = BASE_FILES + 3 * OWN_FILES
    assert a_room(files=files).at_once(9) == (3, "files!")
    assert a_room(files=files, tasks=BASE_TASKS + 2 * (OWN_TASKS + THREADS)).at_once(9) == (2, "tasks!")
    assert a_room(files=0).at_once(9) == (1, "files!")


def test_the_user_of_all_submissions_never_comes_to_the_limit():
    """Where the kernel counts them together, fork servers keep room to start a process."""
    share = a_room(tasks=400, ceiling=1000).share(2)
    assert share.ceiling == 1000 - BASE_TASKS - 2 * OWN_TASKS
    assert share.together <= 400 - BASE_TASKS - 2 * OWN_TASKS


@pytest.fixture
def groups(tmp_path, monkeypatch):
    """Control groups as a container shows them: a version, a path, and a bound on each level."""
    monkeypatch.setattr(room, "_CGROUPS", tmp_path)

    def make(row, **bounds):
        (tmp_path / "row").write_text(f"12:memory:/elsewhere\n{row}\n")
        for place, (most, now) in bounds.items():
            folder = tmp_path / place.replace("__", "/") if place != "top" else tmp_path
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "pids.max").write_text(f"{most}\n")
            (folder / "pids.current").write_text(f"{now}\n")
        real = room.Path

        def path(name):
            return tmp_path / "row" if name == "/proc/self/cgroup" else real(name)

        monkeypatch.setattr(room, "Path", path)
        return [(most, left) for most, left, _ in room._pids()]

    return make


@pytest.mark.parametrize(
    ("row", "bounds", "found"),
    [
        (
            "0::/user/mine",
            {"user__mine": (100, 40), "user": ("max", 50), "top": (300, 10)},
            [(100, 60), (300, 290)],
        ),
        ("8:pids:/docker/abc", {"pids__docker__abc": (64, 4)}, [(64, 60)]),  # an older version
        ("8:pids:/docker/abc", {"pids": (64, 4)}, [(64, 60)]),  # a path that the container does not show
        ("0::/mine", {"mine": ("max", 3), "top": ("what", "ever")}, []),
    ],
)
def test_the_bounds_of_control_groups_of_either_version(groups, row, bounds, found):
    assert groups(row, **bounds) == found


def test_memory_that_may_not_be_had_is_a_shortage():
    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    try:
        resource.setrlimit(resource.RLIMIT_DATA, (4 << 30, hard))
        room.check_memory(4 << 30)
        with pytest.raises(ShortageError, match=r"4097 MB of address space, and 4096 MB are allowed; raise"):
            room.check_memory((4 << 30) + (1 << 20))
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, (soft, hard))
