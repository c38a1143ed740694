"""Where the results of `judge run` go: to the screen, as JSON or as annotations, and into a JUnit file."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.judging_options import EDITOR, JSON, TEXT
from judge.cli.options import write_json
from judge.cli.submissions import Submission, Unjudged, gathered
from judge.cli.target import OutFile
from judge.errors import ExitCode, UsageError, told

if TYPE_CHECKING:
    from judge.cli.fitting import Task
    from judge.cli.picture import Drawing
    from judge.report.layout import Line
    from judge.report.screen import Screen
    from judge.run.result import Result


class OnScreen(Struct, frozen=True):
    """Results for a person: the verdict, or the table of them, last.

    `brief` shows nothing but verdicts, `whole` all there is; between them is what fits on a screen. `drawn`
    asks for the picture of the failing case where there would be no room for it.
    """

    brief: bool
    pointing: bool  # to what comes after an accepted submission
    whole: bool = False
    drawn: bool = False

    def result(self, result: Result, *, several: bool, drawing: Drawing) -> None:
        """One more result, of one or several."""
        from judge.report.layout import line
        from judge.report.results import verdict_lines
        from judge.report.screen import out

        screen = out()
        if not self.brief:
            show = self._whole if self.whole else self._glance
            laid = show(drawing, screen, several=several)
            screen.show([*laid, *([line()] if several else [])])
        elif not several:
            screen.show(verdict_lines(result, screen.width, alone=True))

    def _whole(self, drawing: Drawing, screen: Screen, *, several: bool) -> list[Line]:
        from judge.report.glance import rows_beside, screen_rows
        from judge.report.results import result_lines

        left = screen_rows(screen) - rows_beside(drawing.result, screen.width)
        drawn = self._pointer(drawing, screen, several=several) or drawing.lines(screen, left)
        return list(result_lines(drawing.result, screen.width, drawn))

    def _glance(self, drawing: Drawing, screen: Screen, *, several: bool) -> list[Line]:
        from judge.report.glance import glance_lines, more_lines, screen_rows

        result, rows, hurdle = drawing.result, screen_rows(screen), drawing.hurdle(screen.width)

        def laid(drawn: Sequence[Line]) -> list[Line]:
            more = more_lines(self._more(drawing, drawn=bool(drawn)), screen.width)
            end = more or self._pointer(drawing, screen, several=several)
            return glance_lines(result, screen.width, rows, hurdle=hurdle, drawing=drawn, end=end)

        return drawing.beside(laid, screen, wanted=self.drawn)

    def _pointer(self, drawing: Drawing, screen: Screen, *, several: bool) -> list[Line]:
        """Where to go from an accepted submission."""
        from judge.report.kata import pointer_lines

        if not self.pointing or several or not drawing.result.solved:
            return []
        return pointer_lines(drawing.result.problem, screen)

    def _more(self, drawing: Drawing, *, drawn: bool) -> list[str]:
        """The commands and options that show more of a failure."""
        result = drawing.result
        if result.failure is None or not result.groups:
            return []
        commands = [f"judge show {result.problem} --groups"]
        if drawing.problem.has_hints:
            commands.append(f"judge hint {result.problem}")
        return [
            *commands,
            "--all",
            *(["--picture"] if drawing.drawable and not (drawn or self.drawn) else []),
        ]

    def close(self, results: Sequence[Result], left: int) -> None:
        """The table of several, of which so many are left."""
        from judge.report.results import summary_lines
        from judge.report.screen import out

        if results and len(results) + left > 1:
            screen = out()
            screen.show(summary_lines(results, screen.width, left))


def show_result(drawing: Drawing) -> None:
    """One result by itself, for a person."""
    OnScreen(brief=False, pointing=True).result(drawing.result, several=False, drawing=drawing)


class Outputs:
    """Receives each result and hands it on: to `screen`, or as what `form` asks for, and into a JUnit file.

    `expect` says which submissions results are to come of, once they have been read. Raises UsageError,
    before anything is judged, where the JUnit file cannot be written.
    """

    def __init__(self, form: str, screen: OnScreen, junit: Path | None) -> None:
        self._junit = OutFile(junit, "--junit", "JUnit XML", _is_junit) if junit else None
        if self._junit:
            self._junit.check()
        self.on_screen = form == TEXT and junit is None  # and nowhere else
        self._expected: list[tuple[str, Submission]] = []  # with the problem's name
        self._unjudged: list[Unjudged] = []
        self._form = form
        self._screen = screen
        self._results: list[Result] = []

    def expect(self, tasks: Sequence[Task], unjudged: Sequence[Unjudged]) -> int:
        """How many results are to come: of these submissions, in their order, and of what is not judged."""
        self._expected = [(task.problem.id, each) for task in tasks for each in task.submissions]
        self._unjudged = list(unjudged)
        return len(self._expected) + len(self._unjudged)

    def result(self, result: Result, *, several: bool, drawing: Drawing) -> None:
        """One more result, of one or several, in the order of the submissions."""
        # Kept first: whoever breaks off having seen it finds it in the table.
        self._write(result, drawing.problem.entry, self._expected[len(self._results)][1].source)
        if self._form == TEXT:
            self._screen.result(result, several=several, drawing=drawing)

    def unjudged(self, entry: Unjudged, source: bytes = b"") -> None:
        """One of several that is not judged: a row of the table, and for a script a result like any other."""
        from judge.run.result import judge_fault

        self._write(judge_fault(entry.problem, entry.name, entry.why), "", source)

    def fail(self, problem: str, files: Sequence[str], fault: Exception) -> None:
        """The judge itself failed: a script misses no submission, each that is left has that for its result.

        A wrong use of the command line, or an output that nobody takes, is no such fault. What was not judged
        is not kept in the history.
        """
        if isinstance(fault, UsageError | OSError) or self.on_screen:
            return
        self._expected = self._expected or [(problem, each) for each in gathered(files)[0]]
        for name, submission in self._expected[len(self._results) :]:
            self.unjudged(Unjudged(submission.name, told(fault), name), submission.source)
        self._save()

    def close(self, *, interrupted: bool = False) -> ExitCode:
        """Write what comes last, the rows of what was not judged among it; what the results come to."""
        from judge.run.result import exit_code

        left = len(self._expected) - len(self._results)
        if not interrupted or self._results:
            for entry in self._unjudged:
                self.unjudged(entry)
        if self._form == TEXT:
            mixed = len({result.problem for result in self._results}) > 1
            self._screen.close(sorted(self._results, key=_place) if mixed else self._results, left)
        self._save()
        return exit_code(self._results)

    def _write(self, result: Result, entry: str, source: bytes) -> None:
        """Keep one more result for the file, and write it where a script reads."""
        self._results.append(result)
        if self._form == JSON:
            write_json(result.as_json())
        elif self._form != TEXT:
            encoding = sys.stdout.encoding or "utf-8"
            for text in _at_lines(self._form, result, source, entry):
                sys.stdout.write(text.encode(encoding, "backslashreplace").decode(encoding) + "\n")
            sys.stdout.flush()

    def _save(self) -> None:
        if self._junit is None:
            return
        from judge.report.junit import junit  # only who asks for it waits for it

        self._junit.write(junit(self._results))


def _at_lines(form: str, result: Result, source: bytes, entry: str) -> Iterable[str]:
    """What a form says of the submission's lines; only who asks for it waits for it."""
    if form == EDITOR:
        from judge.report.editor import editor_lines

        return editor_lines(result, source, entry)
    from judge.report.github import annotation

    return [annotation(result, source, entry, os.environ)]


def _is_junit(start: bytes) -> bool:
    return b"<testsuite" in start


def _place(result: Result) -> tuple[str, ...]:
    """Where a submission stands in the table: by its folders and its name, whatever its problem."""
    return Path(result.submission).parts
