"""What a function printed while it was called: shown beside its answer, and never taken for one.

It comes from a file of the submission's own, which nothing of the judge's goes through, and is made plain
text here: a few short lines without anything that a terminal obeys.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.errors import printable
from judge.problem import Verdict
from judge.values.wire import cut

if TYPE_CHECKING:
    from judge.data import ProblemData
    from judge.run.result import Result
    from judge.run.runner import Runner
    from judge.sandbox.boundary import Box

LINES = 5
LENGTH = 160  # characters of a line
_NAMED = 40  # characters of a line within a sentence
_CALLED = (Verdict.WA, Verdict.RTE)


def with_printed(result: Result, data: ProblemData, runner: Runner, box: Box) -> Result:
    """The result with what the function printed on the case that it failed on, called once more and alone."""
    failure = result.failure
    if not runner.calls or failure is None or result.verdict not in _CALLED:
        return result
    if failure.case is None or failure.input is None:
        return result
    from judge.run.group import group_limits  # only after a failure

    group = next(group for group in data.groups if group.group.name == failure.group)
    limits = group_limits(data.problem, group.group)
    printed = text_of(runner.ask(box, [group.cases[failure.case - 1]], limits).printed)
    message = message_of(failure.message, failure.got or "", printed)
    return replace(result, failure=replace(failure, printed=printed, message=message))


def message_of(message: str, got: str, printed: str) -> str:
    """Why an answer is wrong: where there is none, but something was printed, that is why."""
    if not printed or got != "None":
        return message
    first, *more = printed.splitlines()
    short = f"it printed {len(more) + 1} lines" if more else f"it printed {first[:_NAMED]}"
    return f"{short} and returned nothing: return it"


def text_of(printed: bytes) -> str:
    r"""The first lines of what was printed, each short and printable: `\x1b` is written out; "" for none."""
    lines = printed.decode(errors="replace").rstrip().splitlines()
    shown = [printable(cut(line, LENGTH)) for line in lines[:LINES]]
    return "\n".join([*shown, "…"] if len(lines) > LINES else shown)
