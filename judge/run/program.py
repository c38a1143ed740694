"""Program mode: the submission reads a whole group from stdin and writes a line for each case.

T                      number of cases
cx cy r ax ay bx by    the parameters in order, as their types write them; T such lines
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import chain
from typing import Any, ClassVar

from msgspec.structs import replace

from judge.problem import Case, Problem, Verdict
from judge.problem.model import Mode, case_of
from judge.run.result import NOTHING, Behaviour, Failure
from judge.run.runner import OWN_ENDS, VERDICTS, Breakdown, Replies, Runner
from judge.sandbox.boundary import Box, Limits, ProgramResult, Reply, Stop
from judge.values import check, outline, parameters, reading, show
from judge.values.answers import Target
from judge.values.check import ExactOf, Outcome
from judge.values.outline import UNREADABLE, Outline
from judge.values.wire import Raw, cut

SHOWN = 80  # characters of a line that is quoted
_FLOOD = 1 << 20  # bytes that a program has written when its time is up
_CHOKED = re.compile(  # an exception's first words where a line of input is not what the program takes it for
    r"ValueError: (invalid literal|could not convert|(too many|not enough) values to unpack|Invalid literal)"
    r"|EOFError|(decimal\.)?InvalidOperation.*ConversionSyntax"
    r"|IndexError: .*index out of range.*after 0 lines"
)
_PROMPT = re.compile(rb"""\binput\([rRfFbB]?("[ -!#-~]{1,40}"|'[ -&(-~]{1,40}')""")


class ProgramRunner(Runner, frozen=True):
    """Runs the whole program."""

    source: bytes = b""
    mode: ClassVar[Mode] = Mode.PROGRAM
    calls: ClassVar[bool] = False

    def ask(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """One run on all the cases: its work and its imports are one."""
        return _replies(box.run_program(render_group(self.problem, cases), limits), len(cases))

    def decide(self, answer: Any, target: Target, exact: ExactOf) -> Outcome:
        """Compares a line of output."""
        return check.check_line(self.problem.answer, answer, target, exact)

    def wanted(self, target: Target) -> str:
        """The line that a perfect program prints."""
        return show.wanted_line(self.problem.answer, target)

    def outline(self, answer: Any) -> Outline:
        """A wrong line's form and numbers."""
        return outline.line_outline(self.problem.answer, answer)

    def raw(self, answer: Any) -> Raw:
        """What the line holds; None, too, where it holds no answer."""
        read = reading.read_line(self.problem.answer, answer)
        return None if isinstance(read, str) else read[0]

    def explained(self, failure: Failure, does: Behaviour = NOTHING) -> Failure:
        """The failure, told what it could not read, and whether any of its answers could be read."""
        notes = [failure.message]
        if failure.input is not None and _CHOKED.match(failure.message):
            _, row = render_group(self.problem, [case_of(failure.input)]).decode("ascii").splitlines()
            form = form_of_line(self.problem)
            given = f"its input is a line with the number of cases, then one line each: {form}"
            notes.append(f"{given}, here {cut(row, SHOWN)}")
        notes.append(wrong_form(does, self.source))
        return replace(failure, message="; ".join(filter(None, notes)))


def wrong_form(does: Behaviour, source: bytes) -> str:
    """What to say of a program whose wrong answers cannot be read, none of them; nothing for any other."""
    wrong = [form for answers in does.values() for form, _ in answers.wrong.values()]
    passed = sum(each.reached - sum(case < each.reached for case in each.wrong) for each in does.values())
    if len(wrong) < max(2, passed) or any(form != UNREADABLE for form in wrong):
        return ""
    every = "every answer has" if passed == 0 else f"{len(wrong):,} of {len(wrong) + passed:,} answers have"
    prompt = _PROMPT.search(source)
    why = f": the prompt of {prompt[0].decode()}) is printed too, so leave it out" if prompt else ""
    return f"{every} the wrong form{why}"


def render_group(problem: Problem, cases: Sequence[Case]) -> bytes:
    """The standard input of a program that is judged on these cases."""
    types = [parameter.type for parameter in problem.parameters]
    lines = [str(len(cases))]
    for case in cases:
        lines.append(" ".join(chain.from_iterable(map(parameters.tokens, types, case))))
    return ("\n".join(lines) + "\n").encode("ascii")


def form_of_line(problem: Problem) -> str:
    """What stands on a line for a case: `r`, `ax ay`, `points …` for each parameter."""
    words = []
    for each in problem.parameters:
        names = getattr(each.type, "names", ())
        if each.type.width == len(names) and all(map(str.isidentifier, names)):
            words += [f"{each.name.lower()}{name}" for name in names]
        else:
            words.append(each.name if each.type.width == 1 else f"{each.name} …")
    return " ".join(words)


def text_of(stdout: bytes) -> str:
    """An output as text; what is no UTF-8 is written as ASCII."""
    return stdout.decode(errors="backslashreplace").replace("\r\n", "\n")


def answer_lines(stdout: bytes, *, complete: bool) -> list[str]:
    """The lines of an output, without blank ones at its end.

    What is no ASCII stays, and no answer holds it. Where the output is not `complete`, an
    unfinished last line is left out: it may be half a number.
    """
    *lines, rest = text_of(stdout).split("\n")
    if complete:
        lines.append(rest)
    while lines and not lines[-1].strip(" \t"):
        lines.pop()
    return lines


def _replies(result: ProgramResult, count: int) -> Replies:
    """A reply for each line that belongs to a case, and what is wrong with the run as a whole."""
    complete = result.stop is Stop.ANSWERED
    lines = answer_lines(result.stdout, complete=complete)
    breakdown = _breakdown(result, lines, count)
    told_apart = breakdown is None or breakdown.verdict is not Verdict.WA  # which line is which case's answer
    return Replies(
        [Reply(Stop.ANSWERED, line) for line in lines[:count]] if told_apart else [],
        result.usage,
        result.stop,
        result.stop not in OWN_ENDS,
        breakdown,
    )


def _breakdown(result: ProgramResult, lines: Sequence[str], count: int) -> Breakdown | None:
    """What is wrong with a run on so many cases, whatever its lines say; its time or memory are no case's."""
    complete = result.stop is Stop.ANSWERED
    # The lines of a flood are wrong too, or too many: that says less. Its time may be up before its room is.
    flood = result.stop not in OWN_ENDS and len(result.stdout) > _FLOOD and len(lines) > count
    if result.stop is Stop.OUTPUT:
        return Breakdown(VERDICTS[Stop.OUTPUT], result.detail, 0)
    if flood:
        return Breakdown(VERDICTS[Stop.OUTPUT], f"{result.detail}, and went on printing", 0)
    if len(lines) > count or (complete and len(lines) < count):
        what = f"{_counted(len(lines), 'line')} printed, {count} expected: one for each case"
        if len(lines) < count:
            blank = len(result.stdout.splitlines()) > len(lines)
            hint = "; blank lines at the end answer nothing" if blank else ""
            return Breakdown(Verdict.WA, what + hint, 0, "no line")
        surplus, hint = repr(lines[count][:SHOWN]), ""
        if not all(line.strip(" \t") for line in lines):
            hint = ", and no blank lines between"
        elif len(lines) == count + 1:
            hint = f"; the last is {surplus}"
        return Breakdown(Verdict.WA, what, 0, f"more lines: {surplus}", so_far=hint)
    if complete:
        return None
    so_far = f", after {_counted(len(lines), 'line')} of {count}"
    return Breakdown(VERDICTS[result.stop], result.detail, min(len(lines), count - 1), so_far=so_far)


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
