"""A `Box` in this very process: for a routine of one's own and a setter's source, which are trusted.

Nothing is contained. What calls do to the state that the whole process shares is undone at their end, so
that none depends on those of the run before it, nor the caller's next test on any.
"""

from __future__ import annotations

import decimal
import io
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, redirect_stdout
from pathlib import Path
from traceback import walk_tb
from types import CodeType, ModuleType
from typing import Any

from judge.errors import JudgeError
from judge.sandbox.boundary import (
    IMPORTING,
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    Stop,
    Talk,
    Usage,
)
from judge.sandbox.encode import OnObject, encode, found, place_in
from judge.sandbox.inside.source import described, inspect, own_line

Routine = Callable[..., Any]
_HERE = str(Path(__file__).parent)
_SHOWN = 10_000  # bytes of what it printed


class LimitPassed(BaseException):
    """Raised in a submission that has used up its time, its memory or its room for output."""

    def __init__(self, stop: Stop, detail: str) -> None:
        super().__init__(detail)
        self.stop = stop


class Watch:
    """A context manager around the code of a submission, which it may end; this one lets everything go on."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits

    def __enter__(self) -> Watch:
        return self

    def __exit__(self, *exc: object) -> None:
        pass

    def over(self, code: CodeType) -> None:
        """From now on that code is watched, and every function in it."""

    def begin(self) -> None:
        """The calls begin, or the import."""

    def rest(self) -> float:
        """It is over; the seconds that it took, where they are measured."""
        return 0.0

    def still(self) -> bool:
        """Whether another call may begin."""
        return True


class InProcess:
    """See `judge.sandbox.boundary.Box`; of a `routine` there need be no source.

    Only `watch` and Ctrl-C end a call, and no more are made once it says so. `caught` is what costs a call
    alone when it is raised there.
    """

    isolation = ""
    caught: type[BaseException] | tuple[type[BaseException], ...] = Exception

    def __init__(
        self,
        source: bytes = b"",
        name: str = "",
        routine: Routine | None = None,
        watch: Callable[[Limits], Watch] = Watch,
    ) -> None:
        self.raised: BaseException | None = None  # the first one that a call raised
        self._source = source
        self._name = name
        self._routine = routine
        self._watch = watch
        if routine is not None:
            self.caught = Exception, SystemExit, LimitPassed  # not what a test raises to be left out

    def __enter__(self) -> InProcess:
        return self

    def __exit__(self, *exc: object) -> None:
        pass

    def inspect(self) -> Inspection:
        """See `Box.inspect`."""
        return Inspection.read(inspect(self._source, self._name))

    def call(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """See `Box.call`; a routine finds its caller's state anew in each."""
        if self._routine is not None:
            with as_it_was(), self._watch(limits) as watch:
                own = OnObject(self._routine, limits.items) if entry.endswith("()") else self._routine
                routine = _watched(own, watch)
                return CallsResult(tuple(self._replies(routine, calls, limits.items, watch)), Usage())
        with self._process("submission", limits) as (watch, names, printed):
            reply = None
            try:
                self._execute(names, watch)
                routine = found(names, entry, limits.items)
                if routine is None:
                    name = entry.removesuffix("()")
                    reply = Reply(Stop.EXCEPTION, None, f"the module has no {name} once it is imported")
            except self.caught as fault:
                reply = self._ended(fault, IMPORTING)
            if reply is not None:
                lost = len(calls) if reply.stop is Stop.EXCEPTION else 1
                return CallsResult((reply,) * lost, Usage())
            imported = printed.tell()
            watch.begin()
            replies = tuple(self._replies(routine, calls, limits.items, watch))
            spent = watch.rest()
            shown = printed.getvalue()[imported:][:_SHOWN]
            return CallsResult(replies, Usage(spent, spent), printed=shown)

    def _replies(
        self, routine: Routine, calls: Sequence[Sequence[Any]], items: int, watch: Watch
    ) -> Iterator[Reply]:
        for arguments in calls:
            if not watch.still():
                break
            try:
                reply = Reply(Stop.ANSWERED, encode(routine(*arguments), items))
            except self.caught as fault:  # this case is lost, the others are called
                self.raised = self.raised or fault
                reply = self._ended(fault, place_in(routine))
            yield reply
            if not _goes_on(reply):
                break

    def run_program(self, stdin: bytes | Talk, limits: Limits) -> ProgramResult:
        """See `Box.run_program`; one that is talked with needs a process. Raises JudgeError."""
        if not isinstance(stdin, bytes):
            what = "a dialogue is judged on the command line only"
            raise JudgeError(what, remedy="use judge run there")
        stop, detail, spent = Stop.ANSWERED, "", 0.0
        with self._process("__main__", limits, stdin) as (watch, names, printed):
            try:
                self._execute(names, watch)
            except SystemExit as left:
                if left.code not in (None, 0):
                    code = left.code if isinstance(left.code, int) else 1
                    stop, detail = Stop.EXITED, f"exit status {code}"
            except self.caught as fault:
                stop, _, detail = self._ended(fault)
            finally:
                spent = watch.rest()
        return ProgramResult(stop, printed.getvalue(), b"", detail, Usage(spent, spent))

    @contextmanager
    def _process(
        self, module: str, limits: Limits, stdin: bytes = b""
    ) -> Iterator[tuple[Watch, dict[str, Any], _Printed]]:
        """What stands for a process of its own: its watch, the names of its main module, what it prints."""
        made, before = ModuleType(module), sys.modules.get(module)
        made.__dict__.update(__builtins__=__builtins__, __file__=self._name)
        printed, argv, path, reads = _Printed(limits.output_bytes), sys.argv, [*sys.path], sys.stdin
        out = io.TextIOWrapper(printed, "utf-8", write_through=True)
        with as_it_was(), redirect_stdout(out), self._watch(limits) as watch:
            sys.modules[module] = made
            sys.argv, sys.stdin = [self._name], io.TextIOWrapper(io.BytesIO(stdin), "utf-8")
            try:
                yield watch, made.__dict__, printed
            finally:
                watch.rest()
                sys.argv, sys.path[:], sys.stdin = argv, path, reads
                sys.modules.pop(module, None)
                if before is not None:
                    sys.modules[module] = before

    def _execute(self, names: dict[str, Any], watch: Watch) -> None:
        code = compile(self._source, self._name, "exec", dont_inherit=True)
        watch.over(code)
        watch.begin()
        exec(code, names)
        watch.rest()

    def _ended(self, fault: BaseException, where: str = "") -> Reply:
        """The end of a call that raised this."""
        if self._routine is not None:
            if isinstance(fault, LimitPassed):
                return Reply(fault.stop, None, f"{fault}{_place(fault)}")
            return Reply(Stop.EXCEPTION, None, described(fault, "") + _place(fault))
        if not isinstance(fault, LimitPassed):
            stop = Stop.MEMORY if isinstance(fault, MemoryError) else Stop.EXCEPTION
            return Reply(stop, None, described(fault, self._name) + where)
        line = own_line(fault.__traceback__, self._name) if fault.stop is Stop.CPU else 0
        return Reply(fault.stop, None, f"{fault}{f' (line {line})' if line else ''}")


class _Printed(io.BytesIO):
    """What a submission prints, as long as there is room; it cannot be closed."""

    def __init__(self, limit: int) -> None:
        super().__init__()
        self._limit = limit

    def write(self, data: Any) -> int:
        if self.tell() + len(data) > self._limit:
            raise LimitPassed(Stop.OUTPUT, f"printed more than {self._limit >> 20} MB")
        return super().write(data)

    def close(self) -> None:
        """Nothing: what was printed is still to be read."""


def _goes_on(reply: Reply) -> bool:
    return reply.stop in (Stop.ANSWERED, Stop.EXCEPTION)


@contextmanager
def as_it_was() -> Iterator[None]:
    """Undo at the end what was done to the state that the whole process shares."""
    with ExitStack() as undone:
        undone.enter_context(decimal.localcontext())
        undone.enter_context(warnings.catch_warnings())
        # Who imports these only now finds them new: there is nothing to undo.
        if random := sys.modules.get("random"):
            undone.callback(random.setstate, random.getstate())
        if numpy := sys.modules.get("numpy"):
            undone.enter_context(numpy.errstate())
        if numpy_random := sys.modules.get("numpy.random"):
            undone.callback(numpy_random.set_state, numpy_random.get_state())
        undone.callback(sys.set_int_max_str_digits, sys.get_int_max_str_digits())
        undone.callback(sys.setrecursionlimit, sys.getrecursionlimit())  # first: the others need room too
        yield


def _watched(routine: Routine, watch: Watch) -> Routine:
    def called(*arguments: Any) -> Any:
        watch.begin()
        try:
            return routine(*arguments)
        finally:
            watch.rest()

    return called


def _place(fault: BaseException) -> str:
    """Where it was raised, as editors open it, unless that is here."""
    places = [(frame.f_code.co_filename, line) for frame, line in walk_tb(fault.__traceback__)]
    theirs = [each for each in places if not each[0].startswith(_HERE)]
    return " ({}:{})".format(*theirs[-1]) if theirs else ""
