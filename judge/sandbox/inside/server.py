"""The fork server: trusted code only, one per submission, alone with its children.

    "ready" ─┬─ INSPECT   a child compiles the source, so that none that takes the compiler down ever
             │            reaches the server's own; then it does too, and imports what may be
             └─ CALLS or PROGRAM, any number of times: fork, watch, reap, sweep → DONE

The judge hanging up is the end of the server and so of everything it has started; see `seed` for its start.

What is not Python has a server that starts compilers and what they make, and watches them in the same way:

    EXECUTE   payload (command line, environment, folder, limits by name): start it with the three descriptors
    COLLECT   payload (folder, bytes, files): write the names and contents of the ordinary files below the
              folder to the second descriptor, or why that cannot be

What was started has no descriptor of the region and none of the channel: a note there is the server's own.
"""

from __future__ import annotations

import _signal as signal  # type: ignore[import-not-found]  # signal itself wraps every call in enums: slow
import errno
import gc
import marshal
import os
import resource
import select
import stat
import sys
import time

from judge.sandbox.inside import again, child, wire
from judge.sandbox.inside.confine import LINUX, Confinement

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import CodeType
    from typing import Any, NoReturn

SHORTEST_WAIT_NS = 1_000_000
LAST_MOMENT_NS = 50_000_000
SWEEP_SECONDS = 5.0
_PEAK_UNIT = 1 if sys.platform == "darwin" else 1024
_DEFAULTS = (signal.SIGINT, signal.SIGPIPE, signal.SIGUSR1, signal.SIGXFSZ)
_AS_IT_IS = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


class Lacking(OSError):  # noqa: N818 - it never reaches a person
    """The machine had no process left for a child, or no descriptors."""


class Server:
    """The state of one fork server: its one child's pipe and signals, and the compiled source."""

    def __init__(
        self,
        line: wire.Channel,
        region: wire.Region,
        confinement: Confinement,
        config: dict[str, Any],
        source: bytes,
    ) -> None:
        self._line = line
        self._region = region
        self._confinement = confinement
        self._source, self._own_source = source, config["source"]
        self._name: str = child.OWN_FILE if self._own_source else config["name"]
        self._cores: int = config["cores"]
        self._threads: int = config["threads"]
        self._level: str = config["level"]
        self._code: CodeType | None = None
        self._tally, self._tally_end = os.pipe()
        self._deaths, wake_end = os.pipe()
        for number in (self._tally, self._deaths, wake_end):
            os.set_blocking(number, False)
        signal.set_wakeup_fd(wake_end, warn_on_full_buffer=False)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGUSR1, signal.SIG_IGN)  # a child that has no handler for it yet
        self._events = select.poll()
        self._events.register(self._deaths, select.POLLIN)
        self._events.register(line.fileno(), select.POLLIN)  # no request comes now: a STOP, or a hang-up

    def serve(self) -> NoReturn:
        """One request after the other."""
        while True:
            try:
                frame, descriptors = self._line.receive(descriptors=4)
                if not frame:
                    os._exit(0)
                if frame.startswith(wire.STOP):
                    continue
                job = wire.Request(frame, descriptors)
                try:
                    answer = self._run(job)
                    if job.kind == wire.INSPECT:
                        self._prepare()
                except Lacking as lack:
                    answer = wire.LACK.pack(wire.LACKING, lack.errno or 0)
                for number in descriptors:
                    os.close(number)
                self._line.send(answer)
            except (BrokenPipeError, ConnectionError):
                os._exit(0)

    def _prepare(self) -> None:
        """Import ahead what the compiled source asks for, and compile it here."""
        kind, modules = self._region.note()
        if kind != wire.COMPILED:
            return
        for module in modules.split():
            try:
                __import__(module)
            except Exception:  # not installed or broken: the submission's own import says so
                continue
        self._code = compile(self._source, self._name, "exec", dont_inherit=True)
        gc.collect()
        gc.freeze()

    def _run(self, job: wire.Request) -> bytes:
        if len(job.descriptors) < 3 + (job.kind == wire.CALLS and wire.PAUSES):
            raise Lacking(errno.EMFILE, "")  # what there was no room for has not arrived
        try:
            began, pid = again.again(lambda: (time.perf_counter_ns(), os.fork()))
        except OSError as fault:
            raise Lacking(fault.errno, "") from None
        if pid == 0:
            self._be_child(job)
        watch = Clocks(job, began, self._cores)
        reason, status, usage = self._watch(pid, watch)
        wall = time.perf_counter_ns() - watch.began
        cpu = watch.at_end or _cpu_of(usage)
        more = self._sweep(pid)
        self._note_start(watch)
        spent = 0 if watch.before is None else max(0, cpu + more - watch.before)
        peak = usage.ru_maxrss * _PEAK_UNIT
        return wire.DONE.pack(wire.ENDED, status, reason, spent, wall, peak, watch.stage, *watch.imported)

    def _be_child(self, job: wire.Request) -> NoReturn:
        region = self._region
        try:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            self._become(job, region)
        except BaseException as error:
            region.write_fault(error)
        os._exit(99)

    def _become(self, job: wire.Request, region: wire.Region) -> None:
        name, code = self._name, self._code
        signal.signal(signal.SIGINT, signal.default_int_handler)
        child.take_descriptors(*job.descriptors[:3], self._tally_end, *self._own_source)
        limits = {"RLIMIT_AS": job.memory, "RLIMIT_FSIZE": job.output + 1}  # with one more, too much shows
        if not LINUX:  # there, the limit would make the process's CPU clock move by whole timer ticks only
            limits["RLIMIT_CPU"] = job.cpu_ns // 10**9 + 2
        if self._threads:
            limits["RLIMIT_NPROC"] = self._threads
        self._confinement.confine_child(limits)
        if job.kind == wire.INSPECT:
            child.look_at(self._source, name, region, job.stop)
        assert code is not None, "INSPECT comes before this"
        if job.kind == wire.PROGRAM:
            child.be_program(code, name, region)
        child.make_calls(code, name, region, job)

    def _watch(self, pid: int, watch: Clocks) -> tuple[int, int, resource.struct_rusage]:
        """Watch the child until it is dead: the limit that killed it, its status, its usage."""
        while True:
            gone, status, usage = os.wait4(pid, os.WNOHANG | os.WUNTRACED)
            stopped = gone and os.WIFSTOPPED(status)
            if gone and not stopped:
                return wire.NOT_KILLED, status, usage
            self._note_start(watch)
            reason, left = watch.limit(_cpu_clock(pid), time.perf_counter_ns())
            if stopped and not reason and self._goes_on(pid, watch, status):
                os.kill(pid, signal.SIGCONT)
            elif stopped or reason:
                if not stopped:
                    self._ask_where(pid)
                os.kill(pid, signal.SIGKILL)
                _, killed, usage = os.wait4(pid, 0)
                return reason, status if stopped and not reason else killed, usage
            else:
                self._wait(pid, left)

    def _ask_where(self, pid: int) -> None:
        """Let a child whose time is up say where it stands, in a moment."""
        os.kill(pid, signal.SIGUSR1)
        until = time.perf_counter_ns() + LAST_MOMENT_NS
        while time.perf_counter_ns() < until and not self._region.words[wire.STOOD_AT]:
            self._wait(pid, SHORTEST_WAIT_NS)

    def _goes_on(self, pid: int, watch: Clocks, status: int) -> bool:
        """Whether a child that has stopped itself has imported its module, and finds its arguments now."""
        job, region, clock = watch.job, self._region, _cpu_clock(pid)
        answered = region.words[wire.USED] != wire.replies_at(job.payload)  # before it was asked
        if watch.stage != wire.IMPORTING or answered or os.WSTOPSIG(status) != signal.SIGSTOP:
            watch.at_end = clock
            return False
        region.lay(os.pread(job.descriptors[3], job.payload, 0))
        watch.call(clock, os.fstat(job.descriptors[1]).st_size)
        return True

    def _wait(self, pid: int, nanoseconds: int) -> None:
        """Until something dies or the time is over. The judge's hang-up ends all, its STOP the child."""
        for number, event in self._events.poll(nanoseconds / 1e6):
            if number == self._deaths:
                os.read(number, 4096)
            elif event:
                os.kill(pid, signal.SIGKILL)
                if event & select.POLLHUP or not self._line.receive()[0]:
                    self._sweep(pid)
                    os._exit(0)

    def _note_start(self, watch: Clocks) -> None:
        """Start the clocks once the child has told the CPU time before foreign code."""
        if watch.before is None:
            try:
                watch.start(int.from_bytes(os.read(self._tally, 8), "little"))
            except BlockingIOError:
                return

    def _sweep(self, pid: int) -> int:
        """End whatever the child left behind; gives the CPU time of that. What cannot be ended ends us."""
        spent = 0
        until = time.monotonic() + SWEEP_SECONDS
        while time.monotonic() < until:
            try:
                gone, _, usage = os.wait4(-1, os.WNOHANG)
            except ChildProcessError:
                return spent
            if gone:
                spent += _cpu_of(usage)
            else:
                _kill_all([-1] if self._level == "full" else [-pid, *_children()])
        os._exit(1)


class ExecServer(Server):
    """A server whose children become other programs."""

    def _run(self, job: wire.Request) -> bytes:
        return self._collect(job) if job.kind == wire.COLLECT else super()._run(job)

    def _become(self, job: wire.Request, region: wire.Region) -> None:
        for number in _DEFAULTS:
            signal.signal(number, signal.SIG_DFL)
        command, environment, folder, limits = marshal.loads(region.payload(job.payload))
        child.take_descriptors(*job.descriptors[:3], self._tally_end)
        os.chdir(folder)
        self._confinement.confine_child(limits, starts=True)
        child.start_the_clock()
        os.execve(command[0], command, environment)

    def _ask_where(self, pid: int) -> None:
        """Nothing in it would say."""

    def _collect(self, job: wire.Request) -> bytes:
        """Copy the files that a compiler has left, as many and as large as they may be."""
        folder, most, count = marshal.loads(self._region.payload(job.payload))
        found: Any = []
        try:
            for path in _files(folder):
                found.append((os.path.relpath(path, folder), _read(path, most + 1)))
                most, count = most - len(found[-1][1]), count - 1
                if min(most, count) < 0:
                    found = "what was compiled is larger than allowed"
                    break
            with open(job.descriptors[1], "wb", closefd=False) as file:
                marshal.dump(found, file)
        except OSError as fault:
            raise Lacking(fault.errno, "") from None
        return wire.DONE.pack(wire.ENDED, 0, wire.NOT_KILLED, 0, 0, 0, wire.CALLING, 0, 0, 0)


class Clocks:
    """The clocks of one child: of its import, then of its calls; of anything else, from beginning to end."""

    def __init__(self, job: wire.Request, began: int, cores: int) -> None:
        self.job = job
        self.began = began  # of the stage, wall time
        self.cores = cores
        self.stage = wire.NOT_STARTED
        self.before: int | None = None  # CPU time before the stage; unknown until the child has told it
        self.at_end = 0  # CPU time when it stopped itself for the last time, if it did
        self.imported = (0, 0, 0)  # CPU and wall time of the import, bytes that were printed by then
        self.waited = 0  # wall time beyond CPU time, in the import

    def start(self, baseline: int) -> None:
        """Foreign code begins, after so much CPU time."""
        self.before = baseline
        self.stage = wire.IMPORTING if self.job.kind == wire.CALLS and wire.PAUSES else wire.CALLING

    def call(self, clock: int, printed: int) -> None:
        """The import is over, and the calls begin."""
        now = time.perf_counter_ns()
        used = max(0, self._used(clock))
        self.imported = used, now - self.began, printed
        self.waited = max(0, now - self.began - used)
        self.began, self.stage = now, wire.CALLING
        self.before = clock or self.before  # where there is no such clock, the calls are charged for all

    def limit(self, clock: int, now: int) -> tuple[int, int]:
        """The limit of time that is passed, if one is, or else how long none can be."""
        used = self._used(clock)
        passed = now - self.began
        cpu_left = self.job.cpu_ns - used
        waiting_left = self.job.waiting_ns - self.waited - max(0, passed - used)
        wall_left = self.job.wall_ns - passed
        if cpu_left <= 0:
            return wire.FOR_CPU, 0
        if wall_left <= 0:
            return wire.FOR_WALL, 0
        if clock and waiting_left <= 0:  # where there is no such clock, work would look like waiting
            return wire.FOR_WAITING, 0
        soonest = max(cpu_left // self.cores, SHORTEST_WAIT_NS)
        return wire.NOT_KILLED, min(soonest, wall_left, waiting_left if clock else wall_left)

    def _used(self, clock: int) -> int:
        """CPU time of the stage so far."""
        return clock - (self.before or 0)


def _cpu_clock(pid: int) -> int:
    """The CPU time of another process, all its threads, from the kernel; 0 where there is no such clock."""
    try:
        return time.clock_gettime_ns((~pid << 3) | 2)
    except OSError:
        return 0


def _cpu_of(usage: resource.struct_rusage) -> int:
    return round((usage.ru_utime + usage.ru_stime) * 1e9)


def _kill_all(targets: list[int]) -> None:
    """Kill these: processes, and a child's group."""
    for target in targets:
        try:
            os.kill(target, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue


def _children() -> list[int]:
    """This process's children, as /proc tells; none where it does not."""
    me = os.getpid()
    try:
        with open(f"/proc/{me}/task/{me}/children", "rb") as file:  # noqa: PTH123 - pathlib is slow to import
            return list(map(int, file.read().split()))
    except OSError:
        return []


def _files(folder: str) -> Iterator[str]:
    """The ordinary files below a folder, no link followed. Raises OSError for a folder that is closed."""

    def closed(fault: OSError) -> None:
        raise fault

    for base, folders, names in os.walk(folder, onerror=closed):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(base, name)  # noqa: PTH118 - pathlib takes longer to import
            if stat.S_ISREG(os.lstat(path).st_mode):
                yield path


def _read(path: str, most: int) -> bytes:
    """So many bytes of a file at most."""
    with open(os.open(path, _AS_IT_IS), "rb") as file:  # noqa: PTH123
        return file.read(most)
