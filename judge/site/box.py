"""A submission in this very interpreter, which is the worker of a browser's tab: the tab is its sandbox.

`TabBox` is a `judge.sandbox.boundary.Box`. What a submission does for too long is ended by `Watch`, which
counts the jumps and calls of the submission's own code and leaves the worker whole. What spins inside one
call of a built-in cannot be ended from here: the page ends the worker then.
"""

from __future__ import annotations

import io
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from time import perf_counter
from types import CodeType, ModuleType
from typing import Any

from judge.judging.inprocess import InProcess, as_it_was
from judge.sandbox.boundary import IMPORTING, CallsResult, Limits, ProgramResult, Reply, Stop, Usage
from judge.sandbox.encode import encode

SPARE_SECONDS = 2.0  # beyond a limit, or twice it: Python is slower in a tab, and slower when it is watched
_TOOL = 4  # of sys.monitoring, free for whoever wants it
_EACH = 512  # jumps between two looks at the clock; a power of 2
_SHOWN = 10_000  # characters of what it printed
_LONGEST = 500  # characters of an exception's text


class Stopped(BaseException):
    """Raised in the submission where it has used up its time, its memory or its room for output."""

    def __init__(self, stop: Stop, detail: str) -> None:
        super().__init__(detail)
        self.stop, self.detail = stop, detail


class Watch:
    """Ends what goes on for too long, or takes too much memory; a context manager for one process of calls.

    `memory` tells the bytes that the interpreter has. Before Python 3.12, which cannot be asked to count,
    nothing is ended.
    """

    def __init__(self, limits: Limits, memory: Callable[[], int]) -> None:
        allowed = min(limits.cpu_seconds, limits.wall_seconds)
        self.seconds = min(3 * allowed, allowed + SPARE_SECONDS)
        self._allowed, self._memory = limits.memory_bytes, memory
        self._before = memory()
        self.rest()

    def __enter__(self) -> Watch:
        monitoring = getattr(sys, "monitoring", None)
        if monitoring is None:
            return self
        monitoring.use_tool_id(_TOOL, "judge")
        turns = 0

        def turned(*_: object) -> None:
            nonlocal turns
            turns += 1
            if self._late or not turns & (_EACH - 1):
                self.look()

        for event in (monitoring.events.JUMP, monitoring.events.PY_START):
            monitoring.register_callback(_TOOL, event, turned)
        return self

    def __exit__(self, *exc: object) -> None:
        if hasattr(sys, "monitoring"):
            sys.monitoring.free_tool_id(_TOOL)

    def begin(self) -> None:
        """The time of a series begins now."""
        self._end, self._late = perf_counter() + self.seconds, False

    def rest(self) -> None:
        """Nothing is ended until `begin`."""
        self._end, self._late = float("inf"), False

    def look(self) -> None:
        """Raise Stopped where it is time to."""
        if perf_counter() > self._end:
            self._late = True  # from now on at each turn, should the submission catch this one
            raise Stopped(Stop.CPU, f"used more than {self.seconds:g} s of CPU time")
        if self._memory() - self._before > self._allowed:
            raise Stopped(Stop.MEMORY, f"used more than {self._allowed >> 20} MB")

    def over(self, code: CodeType) -> None:
        """Count in this code, and in every function in it."""
        if not hasattr(sys, "monitoring"):
            return
        events = sys.monitoring.events.JUMP | sys.monitoring.events.PY_START
        todo = [code]
        while todo:
            each = todo.pop()
            sys.monitoring.set_local_events(_TOOL, each, events)
            todo += [inner for inner in each.co_consts if isinstance(inner, CodeType)]


class _Printed(io.StringIO):
    """What a submission prints, as long as there is room."""

    def __init__(self, limit: int) -> None:
        super().__init__()
        self._limit = limit

    def write(self, text: str) -> int:
        if self.tell() + len(text) > self._limit:
            raise Stopped(Stop.OUTPUT, f"printed more than {self._limit >> 20} MB")
        return super().write(text)


class TabBox(InProcess):
    """See `judge.sandbox.boundary.Box`. `memory` is for `Watch`; `alive` is called now and then."""

    isolation = "tab"

    def __init__(
        self,
        source: bytes,
        name: str,
        memory: Callable[[], int] = lambda: 0,
        alive: Callable[[], None] = lambda: None,
    ) -> None:
        super().__init__(source, name)
        self._memory, self._alive = memory, alive

    def call_series(
        self,
        entry: str,
        series: Sequence[Sequence[Sequence[Any]]],
        limits: Limits,
        on_series: Callable[[], None] | None = None,
    ) -> list[CallsResult]:
        """See `Box.call_series`."""
        found: list[CallsResult] = []
        with self._process("submission", limits) as (watch, run, printed):
            try:
                function = run()[entry]
            except BaseException as fault:
                reply = self._ended(fault, IMPORTING)
                lost = len(series[0]) if reply.stop is Stop.EXCEPTION else 1
                return [CallsResult((reply,) * lost, Usage())]
            printed.seek(0)
            printed.truncate()
            for calls in series:
                if found and on_series:
                    on_series()
                self._alive()
                begun = perf_counter()
                watch.begin()
                replies = self._replies_of(function, calls, limits.items)
                watch.rest()
                spent = perf_counter() - begun
                shown = printed.getvalue()[:_SHOWN].encode() if len(series) == 1 else b""
                found.append(CallsResult(tuple(replies), Usage(spent, spent), shown))
                if replies[-1].stop not in (Stop.ANSWERED, Stop.EXCEPTION):
                    break
        return found

    def _replies_of(self, function: Any, calls: Sequence[Sequence[Any]], items: int) -> list[Reply]:
        replies: list[Reply] = []
        for arguments in calls:
            try:
                replies.append(Reply(Stop.ANSWERED, encode(function(*arguments), items)))
            except BaseException as fault:  # SystemExit too: the end of this call, not of the next
                replies.append(self._ended(fault))
                if replies[-1].stop is not Stop.EXCEPTION:
                    break
        return replies

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """See `Box.run_program`."""
        before, stop, detail, begun = sys.stdin, Stop.ANSWERED, "", perf_counter()
        self._alive()
        with self._process("__main__", limits) as (watch, run, printed):
            sys.stdin = io.TextIOWrapper(io.BytesIO(stdin), "utf-8")
            try:
                watch.begin()
                run()
            except SystemExit as left:
                if left.code not in (None, 0):
                    stop, detail = Stop.EXITED, f"exit status {left.code}"
            except BaseException as fault:
                stop, _, detail = self._ended(fault)
            finally:
                watch.rest()
                sys.stdin = before
        spent = perf_counter() - begun
        return ProgramResult(stop, printed.getvalue().encode(), b"", detail, Usage(spent, spent))

    @contextmanager
    def _process(
        self, module: str, limits: Limits
    ) -> Iterator[tuple[Watch, Callable[[], dict[str, Any]], _Printed]]:
        """What stands for a process of its own: a watch, what executes the source, and what it prints."""
        made = ModuleType(module)
        made.__dict__.update(__builtins__=__builtins__, __file__=self._name)
        printed, argv, path = _Printed(limits.output_bytes), sys.argv, [*sys.path]
        before = sys.modules.get(module)

        def run() -> dict[str, Any]:
            code = compile(self._source, self._name, "exec", dont_inherit=True)
            watch.over(code)
            watch.begin()
            exec(code, made.__dict__)
            watch.rest()
            return made.__dict__

        with as_it_was(), redirect_stdout(printed), Watch(limits, self._memory) as watch:
            sys.modules[module] = made
            sys.argv = [self._name]
            try:
                yield watch, run, printed
            finally:
                watch.rest()
                sys.argv, sys.path[:] = argv, path
                sys.modules.pop(module, None)
                if before is not None:
                    sys.modules[module] = before

    def _ended(self, fault: BaseException, where: str = "") -> Reply:
        """The end of a call that raised this."""
        line, step = 0, fault.__traceback__
        while step is not None:
            if step.tb_frame.f_code.co_filename == self._name:
                line = step.tb_lineno
            step = step.tb_next
        at = f" (line {line})" if line else ""
        if isinstance(fault, Stopped):
            return Reply(fault.stop, None, f"{fault.detail}{at if fault.stop is Stop.CPU else ''}")
        if isinstance(fault, MemoryError):
            return Reply(Stop.MEMORY, None, f"asked for more memory than this tab has{at}")
        try:
            text = " ".join(str(fault)[: 4 * _LONGEST].split())[:_LONGEST]
        except BaseException:
            text = "(its text cannot be shown)"
        what = f"{type(fault).__name__}: {text}" if text else type(fault).__name__
        return Reply(Stop.EXCEPTION, None, f"{what}{at}{where}")
