"""A dialogue: what a FORMAT's `talk` says to a program and hears of it, and what both have said."""

from __future__ import annotations

import re
import time
from collections import deque

from judge.errors import printable
from judge.problem import Case, Problem
from judge.problem.declare import Format
from judge.problem.module import blaming
from judge.sandbox.boundary import Conversation, ProgramResult, Reply, Stop
from judge.values.wire import cut

_LINES = 20  # of a dialogue that are shown, the last ones
_COLUMNS = 200
_LONGEST = 120  # characters of why a program is wrong
_BRIEF = 20  # of a line that is quoted
_OWN = 1.0  # seconds that a talk may take for itself, whatever the limit
_INT = re.compile(r"[+-]?[0-9]{1,30}")
_WAITED = (Stop.WALL, Stop.WAITING)
_PASSED = (*_WAITED, Stop.CPU, Stop.MEMORY, Stop.OUTPUT, Stop.TAMPERED)  # limits, which come before all else
_UNHEARD = "; does it end each line with a line feed, and flush it?"
_EARLY = "the program ended before the dialogue did"


class Wrong(Exception):  # noqa: N818 - of the program, not of the talk
    """Why the program is wrong."""


class Program:
    """The program that `talk` talks with."""

    def __init__(self, line: Conversation) -> None:
        self.said: deque[str] = deque(maxlen=_LINES + 1)
        self.waited = self.longest = 0.0  # seconds, for the program: in all, and for one line
        self.ended = False  # whether its end was heard
        self._line = line

    def say(self, *words: object) -> None:
        """Write a line to it: the words with a blank between them."""
        text = " ".join(map(str, words))
        self.said += [f"> {_cut(row)}" for row in text.split("\n")[-_LINES:]]
        began = time.perf_counter()
        self._line.say(f"{text}\n".encode("ascii"))
        self.waited += time.perf_counter() - began

    def hear(self) -> str:
        """Its next line, without the line feed; "" where it has ended."""
        began = time.perf_counter()
        data = self._line.hear()
        waited = time.perf_counter() - began
        self.waited, self.longest, self.ended = self.waited + waited, max(waited, self.longest), not data
        text = data.decode("ascii", "backslashreplace").rstrip("\r\n")
        if data:
            self.said.append(f"< {_cut(text)}" + "  (without a line feed)" * (not data.endswith(b"\n")))
        return text

    def hear_int(self, low: int, high: int) -> int:
        """The number in its next line. Where that holds none from low to high, the program is wrong."""
        text = self.hear().strip()
        if _INT.fullmatch(text) and low <= int(text) <= high:
            return int(text)
        why = f"a number from {low} to {high} is expected"
        raise Wrong(f"the program ended, where {why}" if self.ended else f"{why}, not {text[:_BRIEF]!r}")


class Talk:
    """One dialogue about a case, to be held by a box; see `judge.sandbox.boundary.Talk`."""

    def __init__(self, problem: Problem, own: Format, case: Case) -> None:
        self._why: str | None = None  # the program is wrong
        self._took: float | None = None  # seconds, of a talk that is over
        self._problem, self._own, self._case = problem, own, case
        self._program: Program | None = None

    def __call__(self, line: Conversation) -> bool:
        """Hold it; whether the program may go on to its own end."""
        talk, self._program = self._own.talk, Program(line)
        assert talk is not None
        self._why, began = _EARLY, time.perf_counter()  # whatever ends the talk
        try:
            with blaming(self._problem, "FORMAT: talk fails"):
                try:
                    why = talk(self._program, *self._problem.calls([self._case])[0])
                except Wrong as wrong:
                    why = str(wrong)
            if why is not None and not (isinstance(why, str) and why.strip()):
                what = f"FORMAT: talk returns {repr(why)[:_BRIEF]}"
                raise self._problem.fault(what, "return None, or say why the program is wrong")
            self._why = printable(why[:_LONGEST]) if why else None
        finally:
            self._took = time.perf_counter() - began
        return self._why is None

    def reply(self, result: ProgramResult) -> Reply:
        """What came of it: why the program is wrong, "" for a right one. Raises ProblemError.

        Limits come first, then what `talk` says, unless it only heard the end of a program that failed.
        """
        program, stop, wall = self._program, result.stop, result.usage.wall_seconds
        if program is None:  # it was never begun
            return Reply(stop, None, result.detail)
        if self._took is None or (stop in _WAITED and self.own > max(wall / 2, _OWN)):
            what = "FORMAT: talk works on, and the program waits for it"
            raise self._problem.fault(what, "make talk come to an end, or take less time")
        if stop in _PASSED:
            detail = result.detail
            if stop in _WAITED and program.longest > wall / 2:
                detail += _UNHEARD if result.usage.slept_seconds else ""
            elif stop in _WAITED and (program.ended or self._why == _EARLY):
                detail = f"the dialogue was not over after {wall:.3g} s"
            return Reply(stop, None, detail)
        failed = stop is not Stop.ANSWERED
        if self._why and not (failed and program.ended):
            return Reply(Stop.ANSWERED, self._why)
        if failed:
            return Reply(stop, None, result.detail)
        more = result.stdout.strip()[: _LINES * _COLUMNS].decode("ascii", "backslashreplace")
        program.said += [f"< {_cut(row)}" for row in more.splitlines()[: _LINES // 2]]
        return Reply(Stop.ANSWERED, f"it prints {more[:_BRIEF]!r} after the dialogue" if more else "")

    @property
    def own(self) -> float:
        """The seconds in which the program waited for the talk."""
        return max(0.0, (self._took or 0.0) - (self._program.waited if self._program else 0.0))

    @property
    def text(self) -> str:
        """The last lines of both sides, `> ` before those that the program was told."""
        said = [*self._program.said] if self._program else []
        return "\n".join(["…", *said[-_LINES:]] if len(said) > _LINES else said)


def _cut(text: str) -> str:
    return printable(cut(text, _COLUMNS))
