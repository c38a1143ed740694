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
from judge.cli.submissions import Submission, read_submissions
from judge.cli.target import OutFile
from judge.errors import ExitCode, UsageError, told

if TYPE_CHECKING:
    from judge.cli.picture import Drawing
    from judge.run.result import Result


class OnScreen(Struct, frozen=True):
    """Results for a person: the verdict, or the table of them, last."""

    brief: bool
    pointing: bool  # to what comes after an accepted submission

    def result(self, result: Result, *, several: bool, drawing: Drawing) -> None:
        """One more result, of one or several."""
        from judge.report.kata import pointer_lines
        from judge.report.layout import line
        from judge.report.results import lines_beside, result_lines, verdict_lines
        from judge.report.screen import out

        screen = out()
        if not self.brief:
            drawn = drawing.lines(screen, beside=lines_beside(result, screen.width))
            if self.pointing and not several and result.exit_code is ExitCode.ACCEPTED:
                drawn = pointer_lines(result.problem, screen)
            screen.show([*result_lines(result, screen.width, drawn), *([line()] if several else [])])
        elif not several:
            screen.show(verdict_lines(result, screen.width, alone=True))

    def close(self, results: Sequence[Result]) -> None:
        """The table of several."""
        from judge.report.results import summary_lines
        from judge.report.screen import out

        if len(results) > 1:
            screen = out()
            screen.show(summary_lines(results, screen.width))


def show_result(drawing: Drawing) -> None:
    """One result by itself, for a person."""
    OnScreen(brief=False, pointing=True).result(drawing.result, several=False, drawing=drawing)


class Outputs:
    """Receives each result and hands it on: to `screen`, or as what `form` asks for, and into a JUnit file.

    `expected` are the submissions that results are to come of, once they have been read. Raises UsageError,
    before anything is judged, where the JUnit file cannot be written.
    """

    def __init__(self, form: str, screen: OnScreen, junit: Path | None) -> None:
        self._junit = OutFile(junit, "--junit", "JUnit XML", _is_junit) if junit else None
        if self._junit:
            self._junit.check()
        self.on_screen = form == TEXT and junit is None  # and nowhere else
        self.expected: Sequence[Submission] = ()
        self._form = form
        self._screen = screen
        self._results: list[Result] = []

    def result(self, result: Result, *, several: bool, drawing: Drawing) -> None:
        """One more result, of one or several, in the order of the submissions."""
        if self._form == TEXT:
            self._screen.result(result, several=several, drawing=drawing)
        self._write(result, drawing.problem.entry)

    def fail(self, problem: str, files: Sequence[str], fault: Exception) -> None:
        """The judge itself failed: a script misses no submission, each that is left has that for its result.

        A wrong use of the command line, or an output that nobody takes, is no such fault. What was not judged
        is not kept in the history.
        """
        if isinstance(fault, UsageError | OSError) or self.on_screen:
            return
        from judge.run.execute import judge_fault

        self.expected = self.expected or read_submissions(files)
        for submission in self.expected[len(self._results) :]:
            self._write(judge_fault(problem, submission.name, told(fault)), "")
        self._save()

    def close(self) -> ExitCode:
        """Write what comes last; what the results come to."""
        from judge.run.result import exit_code

        if self._form == TEXT:
            self._screen.close(self._results)
        self._save()
        return exit_code(self._results)

    def _write(self, result: Result, entry: str) -> None:
        """Keep one more result for the file, and write it where a script reads."""
        source = self.expected[len(self._results)].source
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
