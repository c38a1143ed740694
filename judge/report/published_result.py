"""What `judge run` returns: a result, and what several came to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import ExitCode
from judge.run.result import Result, exit_code

if TYPE_CHECKING:
    from judge.data import ProblemData
    from judge.report.published_look import Standing


class RunReport(Struct, frozen=True):
    """One result with all that its screen shows; it is explained and drawn from `source` and `data`.

    `quiet` shows the verdict alone; one of `several` is a line, with its kata where these are of more than
    one. `whole` shows every group, `commands` those that go on, `key` the one that does in a loop. `standing`
    says what an accepted one took, `fresh` what a run on fresh cases did. `plain` are lines for another
    program, written instead.
    """

    result: Result
    source: bytes = b""
    data: ProblemData | None = None
    quiet: bool = False
    several: int = 0  # katas that the submissions are of, 0 for a single one
    whole: bool = False
    commands: bool = True
    key: str = ""
    standing: Standing | None = None
    fresh: str = ""
    plain: str = ""

    @property
    def published(self) -> tuple[Result]:
        """What goes out as JSON."""
        return (self.result,)

    @property
    def line(self) -> str:
        """All that is shown of it, where that is one line without a layout."""
        if self.several or not self.quiet:
            return ""
        from judge.report.tell import tell

        problem = self.data.problem if self.data else None
        return "  ".join(tell(problem, self.result, self.source).line(self.result.submission))

    @property
    def exit_code(self) -> ExitCode:
        """What it tells the shell."""
        return self.result.exit_code


class Several(Struct, frozen=True):
    """What several submissions came to, of which so many are left."""

    results: tuple[Result, ...]
    left: int = 0
    published: tuple[()] = ()  # each result went out by itself

    @property
    def exit_code(self) -> ExitCode:
        """What they tell the shell together."""
        return exit_code(self.results)
