"""Programs with a format of the kata's own: each case is a run, and its whole output one answer.

A program that is talked with answers "", or why it is wrong: there is nothing to compare.

The limits hold for all runs of a group together. A run that fails costs its own case alone.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property
from typing import Any, ClassVar

from msgspec import field
from msgspec.structs import replace

from judge.problem import Case
from judge.problem.declare import Format
from judge.problem.formats import input_of, output_of
from judge.problem.model import Mode, case_of
from judge.problem.module import load_module
from judge.run.group import limits_after
from judge.run.program import text_of
from judge.run.result import NOTHING, Behaviour, Failure
from judge.run.runner import OWN_ENDS, Replies, Runner
from judge.run.talk import Talk
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage
from judge.sandbox.encode import encode
from judge.values import reading
from judge.values.answers import Target
from judge.values.check import Accepted, ExactOf, Outcome, Rejection
from judge.values.outline import UNREADABLE, Outline
from judge.values.wire import Raw, Unreadable, cut

_LINES = 20  # of an input or an output that are shown
_COLUMNS = 200
_LONGEST = 120  # characters of why an output cannot be read
_NUMBER = re.compile(r"-?[0-9]+")
_LEAST = 1e-3  # seconds of a run whose group has used all of its time


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
