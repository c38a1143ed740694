"""What a FORMAT promises: it reads what it shows, and of an output that holds no answer it says why.

So does its talk of a program that says something odd, and ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import partial

from judge.data import ProblemData
from judge.errors import ProblemError
from judge.problem.declare import Format
from judge.problem.formats import input_of, output_of
from judge.run.formatted import FormatRunner, Talk
from judge.sandbox.dialogue import DialogueEnded
from judge.values.check import Rejection
from judge.verify.model import Fault, fault_of

_ODD = ("", "\n", "?\n")  # outputs of a program that is not done
_SHOWN = 60
_PATIENCE = 100  # times that somebody may talk to such a program


class _Odd:
    """A program that writes that, and no more; see `judge.sandbox.boundary.Line`."""

    def __init__(self, text: str) -> None:
        self._text = text.encode()
        self._left = _PATIENCE

    def say(self, _data: bytes) -> None:
        self._left -= 1
        if self._left < 0:
            raise DialogueEnded

    def hear(self) -> bytes:
        self.say(b"")
        text, self._text = self._text, b""
        return text


def format_faults(data: ProblemData) -> Iterator[Fault]:
    """The first case that is not written, or whose answer is not read as it is shown."""
    problem, own, where = data.problem, data.module.format, f"{data.problem.id}/problem.py"
    if own is None or problem.talks:
        return
    decide = FormatRunner(problem).decide
    for group in data.groups:
        for case, target in zip(group.cases, group.targets, strict=True):
            try:
                input_of(problem, own, case)
                output = output_of(problem, own, target)
            except ProblemError as error:
                yield fault_of(error, where)
                return
            outcome = decide(output, target, partial(data.exact, case, group.group))
            if isinstance(outcome, Rejection):
                what = f"FORMAT: show gives {repr(output)[:_SHOWN]}, which read refuses: {outcome.message}"
                yield Fault(what, where, "make read and show agree")
                return


def odd_outputs(data: ProblemData) -> Iterator[Fault]:
    """Outputs on which `read` fails itself, so that a learner hears no reason."""
    own = data.module.format
    if own and own.talk:
        yield from _odd_talks(data, own)
    for text in _ODD if own and own.read else ():
        try:
            own.read(text)  # type: ignore[misc, union-attr]  # it is there
        except ValueError:
            pass
        except Exception as fault:
            what = f"FORMAT: read({text!r}) raises {type(fault).__name__}"
            yield Fault(what, f"{data.problem.id}/problem.py", "raise ValueError with what is wrong")


def _odd_talks(data: ProblemData, own: Format) -> Iterator[Fault]:
    """The first program on which `talk` fails itself, so that nobody is judged."""
    for text in _ODD:
        for case in data.module.examples:
            try:
                with suppress(DialogueEnded):
                    Talk(data.problem, own, case)(_Odd(text))
            except ProblemError as error:
                what = f"{error.what}, where the program prints {text!r}"
                yield Fault(what, error.where or "", "use hear_int, or look at what hear returns")
                return
