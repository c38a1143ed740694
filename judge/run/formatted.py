"""Programs with a format of the kata's own: each case is a run, and its whole output one answer.

A program that is talked with answers "", or why it is wrong: there is nothing to compare. What a FORMAT's
`talk` says to it and hears of it is a dialogue.

The limits hold for all runs of a group together. A run that fails costs its own case alone.
"""

from __future__ import annotations

import re
import time
from collections import deque
from collections.abc import Sequence
from functools import cached_property
from typing import Any, ClassVar

from msgspec import field
from msgspec.structs import replace

from judge.errors import printable
from judge.problem import Case, Problem
from judge.problem.declare import Format
from judge.problem.formats import input_of, output_of
from judge.problem.model import Mode, case_of
from judge.problem.module import blaming, load_module
from judge.run.group import limits_after
from judge.run.program import text_of
from judge.run.result import NOTHING, Behaviour, Failure
from judge.run.runner import OWN_ENDS, Replies, Runner
from judge.sandbox.boundary import Box, Conversation, Limits, ProgramResult, Reply, Stop, Usage
from judge.sandbox.encode import encode
from judge.values import reading
from judge.values.answers import Target
from judge.values.check import Accepted, ExactOf, Outcome, Rejection
from judge.values.outline import UNREADABLE, Outline
from judge.values.wire import Raw, Unreadable, cut

_LINES = 20  # of an input, an output or a dialogue that are shown
_COLUMNS = 200
_LONGEST = 120  # characters of why an output cannot be read, or a program is wrong
_NUMBER = re.compile(r"-?[0-9]+")
_LEAST = 1e-3  # seconds of a run whose group has used all of its time
_BRIEF = 20  # of a line that is quoted
_OWN = 1.0  # seconds that a talk may take for itself, whatever the limit
_INT = re.compile(r"[+-]?[0-9]{1,30}")
_WAITED = (Stop.WALL, Stop.WAITING)
_PASSED = (*_WAITED, Stop.CPU, Stop.MEMORY, Stop.OUTPUT, Stop.TAMPERED)  # limits, which come before all else
_UNHEARD = "; does it end each line with a line feed, and flush it?"
_EARLY = "the program ended before the dialogue did"


class FormatRunner(Runner, frozen=True, dict=True):
    """Runs the program once for each case."""

    mode: ClassVar[Mode] = Mode.PROGRAM
    calls: ClassVar[bool] = False
    _said: dict[str, str] = field(
        default_factory=dict
    )  # by their case, in dialogues that went wrong or were held alone

    @cached_property
    def _own(self) -> Format:
        own = load_module(self.problem).format
        assert own is not None
        return own

    def ask(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """A run for each case, until one is ended by force."""
        replies, used, stop = list[Reply](), Usage(), Stop.ANSWERED
        for case in cases:
            left = limits_after(limits, used, _LEAST)
            if self.problem.talks:
                talk = Talk(self.problem, self._own, case)
                result = box.run_program(talk, left)
                replies.append(talk.reply(result))
                wall = max(0.0, result.usage.wall_seconds - talk.own)
                result = result._replace(usage=result.usage._replace(wall_seconds=wall))
                if replies[-1].answer != "" or len(cases) == 1:
                    self._said[repr(case)] = talk.text
            else:
                result = box.run_program(input_of(self.problem, self._own, case).encode(), left)
                replies.append(Reply(result.stop, text_of(result.stdout), result.detail))
            used += result.usage
            if result.stop not in OWN_ENDS:
                stop = result.stop
                if stop is Stop.CPU and replies[1:]:  # what was left is no limit that anybody knows
                    replies[-1] = replies[-1]._replace(
                        detail=f"{len(replies)} runs took more than {limits.cpu_seconds:g} s of CPU time"
                    )
                break
        return Replies(replies, used, stop, lost=stop is not Stop.ANSWERED)

    def decide(self, answer: Any, target: Target, exact: ExactOf) -> Outcome:
        """Holds an output against a target."""
        if self.problem.talks:
            return Rejection(answer, "", "") if answer else Accepted()
        try:
            outcome = super().decide(self._read(answer), target, exact)
        except Unreadable as why:
            outcome = Rejection(str(why), "", "")
        if isinstance(outcome, Rejection):
            return replace(outcome, wanted=self.wanted(target), got=shown(answer))
        return outcome

    def _read(self, output: str) -> Raw:
        """The answer in an output; raises Unreadable. The setter's code reads whatever a program printed."""
        type_, own = self.problem.answer, self._own
        if own.read is None:
            if not output.split():
                raise Unreadable("nothing was printed")
            read = reading.read_line(type_, " ".join(output.splitlines()))
            if isinstance(read, str):
                raise Unreadable(read.replace("one line holds", "the output holds"))
            return read[0]
        try:
            return encode(own.read(output), type_.items)
        except ValueError as why:
            said = str(why)
        except Exception as fault:  # of an output that the setter did not think of
            said = f"the output cannot be read: {type(fault).__name__}"
        raise Unreadable(said.splitlines()[0][:_LONGEST] if said.strip() else "the output cannot be read")

    def wanted(self, target: Target) -> str:
        """The output of a perfect program; nothing in a dialogue."""
        return "" if self.problem.talks else shown(output_of(self.problem, self._own, target))

    def outline(self, answer: Any) -> Outline:
        """A wrong answer's form and numbers."""
        if self.problem.talks:
            return f"told {_NUMBER.sub('0', answer)}", ()
        try:
            return super().outline(self._read(answer))
        except Unreadable:
            return UNREADABLE, ()

    def raw(self, answer: Any) -> Raw:
        """What the output holds; None where it holds no answer."""
        if self.problem.talks:
            return None
        try:
            return self._read(answer)
        except Unreadable:
            return None

    def explained(self, failure: Failure, does: Behaviour = NOTHING) -> Failure:  # noqa: ARG002
        """The failure with what the program read, or what was said."""
        if failure.input is None:
            return failure
        case = case_of(failure.input)
        if self.problem.talks:
            return replace(failure, shown=self._said.get(repr(case), ""))
        return replace(failure, shown=shown(input_of(self.problem, self._own, case)))


def shown(text: str) -> str:
    """The first lines of an input or an output, each cut where it is long."""
    lines = [cut(line, _COLUMNS) for line in text.splitlines()]
    return "\n".join(lines[:_LINES] + ["…"] * (len(lines) > _LINES)) if text.strip() else "nothing"


class Wrong(Exception):  # noqa: N818 - of the program, not of the talk
    """Why the program is wrong."""


class Talk:
    """One dialogue about a case, to be held by a box; see `judge.sandbox.boundary.Talk`.

    It is the program that `talk` talks with, too.
    """

    def __init__(self, problem: Problem, own: Format, case: Case) -> None:
        self._why: str | None = None  # the program is wrong
        self._took: float | None = None  # seconds, of a talk that is over
        self._problem, self._own, self._case = problem, own, case
        self._line: Conversation | None = None  # once it is begun
        self._said: deque[str] = deque(maxlen=_LINES + 1)
        self._waited = self._longest = 0.0  # seconds, for the program: in all, and for one line
        self._ended = False  # whether the program's end was heard

    def say(self, *words: object) -> None:
        """Write a line to it: the words with a blank between them."""
        assert self._line is not None
        text = " ".join(map(str, words))
        self._said += [f"> {_cut(row)}" for row in text.split("\n")[-_LINES:]]
        began = time.perf_counter()
        self._line.say(f"{text}\n".encode("ascii"))
        self._waited += time.perf_counter() - began

    def hear(self) -> str:
        """Its next line, without the line feed; "" where it has ended."""
        assert self._line is not None
        began = time.perf_counter()
        data = self._line.hear()
        waited = time.perf_counter() - began
        self._waited, self._longest, self._ended = self._waited + waited, max(waited, self._longest), not data
        text = data.decode("ascii", "backslashreplace").rstrip("\r\n")
        if data:
            self._said.append(f"< {_cut(text)}" + "  (without a line feed)" * (not data.endswith(b"\n")))
        return text

    def hear_int(self, low: int, high: int) -> int:
        """The number in its next line. Where that holds none from low to high, the program is wrong."""
        text = self.hear().strip()
        if _INT.fullmatch(text) and low <= int(text) <= high:
            return int(text)
        why = f"a number from {low} to {high} is expected"
        raise Wrong(f"the program ended, where {why}" if self._ended else f"{why}, not {text[:_BRIEF]!r}")

    def __call__(self, line: Conversation) -> bool:
        """Hold it; whether the program may go on to its own end."""
        talk, self._line = self._own.talk, line
        assert talk is not None
        self._why, began = _EARLY, time.perf_counter()  # whatever ends the talk
        try:
            with blaming(self._problem, "FORMAT: talk fails"):
                try:
                    why = talk(self, *self._problem.calls([self._case])[0])
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
        stop, wall, failed = result.stop, result.usage.wall_seconds, result.stop is not Stop.ANSWERED
        if self._line is None:
            return Reply(stop, None, result.detail)
        if self._took is None or (stop in _WAITED and self.own > max(wall / 2, _OWN)):
            what = "FORMAT: talk works on, and the program waits for it"
            raise self._problem.fault(what, "make talk come to an end, or take less time")
        detail = result.detail
        if stop in _WAITED and self._longest > wall / 2:
            detail += _UNHEARD if result.usage.slept_seconds else ""
        elif stop in _WAITED and (self._ended or self._why == _EARLY):
            detail = f"the dialogue was not over after {wall:.3g} s"
        if stop in _PASSED or (failed and (self._ended or not self._why)):
            return Reply(stop, None, detail)
        if self._why:
            return Reply(Stop.ANSWERED, self._why)
        more = result.stdout.strip()[: _LINES * _COLUMNS].decode("ascii", "backslashreplace")
        self._said += [f"< {_cut(row)}" for row in more.splitlines()[: _LINES // 2]]
        return Reply(Stop.ANSWERED, f"it prints {more[:_BRIEF]!r} after the dialogue" if more else "")

    @property
    def own(self) -> float:
        """The seconds in which the program waited for the talk."""
        return max(0.0, (self._took or 0.0) - self._waited)

    @property
    def text(self) -> str:
        """The last lines of both sides, `> ` before those that the program was told."""
        said = [*self._said]
        return "\n".join(["…", *said[-_LINES:]] if len(said) > _LINES else said)


def _cut(text: str) -> str:
    return printable(cut(text, _COLUMNS))
