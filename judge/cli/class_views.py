"""What a class is shown after its table: the cohort, the files that were asked for, what is alike."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.batch.model import Handin, Row
from judge.batch.outcome import Outcome
from judge.cli.target import OutFile, moment
from judge.errors import JudgeError, unwritable
from judge.judging.job import RunOptions
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.screen import note, out
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.report.cohort import Cohort


class Views(Struct, frozen=True):
    """The files that a person has asked for, and how much of the cohort; `similar` names a detector."""

    csv: Path | None = None
    html: Path | None = None
    feedback: Path | None = None
    junit: Path | None = None
    similar: str | None = None
    whole: bool = False

    @property
    def any_file(self) -> bool:
        """Whether anything but the screen was asked for."""
        return any((self.csv, self.html, self.feedback, self.junit, self.similar))

    def check(self) -> None:
        """Refuse, before anything is judged, what cannot be written. Raises UsageError."""
        for target in self._targets().values():
            target.check()
        if self.html or self.feedback:
            moment()
        if self.feedback:
            try:
                self.feedback.mkdir(exist_ok=True)
            except OSError as fault:
                raise unwritable(self.feedback, fault, "name another folder with --feedback") from fault

    def _targets(self) -> dict[str, OutFile]:
        from judge.report.cohort import is_gradebook

        kinds = {
            "csv": (self.csv, "gradebook", is_gradebook),
            "html": (self.html, "page of a class", _is_class_page),
            "junit": (self.junit, "JUnit XML", _is_junit),
        }
        return {
            name: OutFile(path, f"--{name}", kind, ours) for name, (path, kind, ours) in kinds.items() if path
        }

    def show(self, scene: Scene, *, screen: bool) -> dict[str, Any]:
        """Write the files and, where a person reads, show the cohort; the cohort as it is published.

        Raises:
            UsageError: a file cannot be written.
        """
        cohort = scene.cohort()
        if screen:
            from judge.report.klass import cohort_lines
            from judge.report.picture import writes

            shown = out()
            block = "▇" if writes(shown, "▇") else "#"
            lines = list(cohort_lines(cohort, shown.width, whole=self.whole, block=block))
            while lines and not lines[-1]:
                lines.pop()
            shown.show([(), *lines] if lines else [])
        self._write(scene, cohort)
        if self.similar:
            _tell_similar(scene)
        return cohort.as_json()

    def _write(self, scene: Scene, cohort: Cohort) -> None:
        targets = self._targets()
        if "csv" in targets:
            from judge.report.cohort import gradebook

            targets["csv"].write(gradebook(cohort))
        if "junit" in targets:
            from judge.report.formats import junit

            targets["junit"].write(junit([row.result for row in scene.outcome.rows]))
        if not (self.html or self.feedback):
            return
        from judge.report.html.klass import class_page, feedback_pages

        results = scene.results(cohort, everybody=self.feedback is not None)
        title = scene.folder.resolve().name or "class"
        if self.html:
            page = class_page(cohort, results, scene.problems, title=title, generated=moment())
            targets["html"].write(page)
        if self.feedback:
            pages = feedback_pages(cohort, results, scene.problems, title=title, generated=moment())
            for name, content in pages:
                target = OutFile(self.feedback / name, "--feedback", "feedback page", _is_feedback)
                target.check()
                target.write(content)


class Scene(Struct, frozen=True):
    """A class that was judged: what it came to, what was handed in, and all that was handed in before.

    `problems` are those that are still there.
    """

    folder: Path
    store: Path
    outcome: Outcome
    handins: Sequence[Handin]
    history: Sequence[Row]
    problems: Mapping[str, Problem]
    options: RunOptions

    def cohort(self) -> Cohort:
        """The class as it stands."""
        from judge.batch.cohort import cohort_of
        from judge.batch.equal import equal_files

        present = {(row.problem, row.file) for row in self.outcome.rows}
        handins = [each for each in self.handins if (each.problem, each.file) in present]
        return cohort_of(self.outcome, self.history, equal_files(handins, self.problems))

    def results(self, cohort: Cohort, *, everybody: bool) -> dict[tuple[str, str], Result]:
        """What pages show, the smallest cases found now: one hand-in a mistake, or all that count."""
        from judge.batch.outcome import counting
        from judge.batch.representatives import representatives, smallest_cases
        from judge.report.progress import progress

        all_rows = self.outcome.rows
        rows = list(counting(all_rows).values()) if everybody else representatives(cohort, all_rows)
        return smallest_cases(rows, self.handins, self.problems, self.options, progress)


def problems_of(names: Sequence[str], folders: Sequence[Path]) -> dict[str, Problem]:
    """The problems of these ids that can be read; of the others the table has told."""
    found = {}
    for name in names:
        try:
            found[name] = find_problem(name, folders)
        except JudgeError:
            continue
    return found


def _tell_similar(scene: Scene) -> None:
    """Write what Dolos reads, call it where it is there, and say where everything is."""
    from judge.batch.similar import INSTALL, compared, dolos, similar_folder

    folder = similar_folder(scene.store)
    told = compared(folder, scene.outcome, scene.handins, scene.problems)
    if not told:
        note("nothing for Dolos to compare: no problem has files of two students in one language")
        return
    for each in told:
        if each.report:
            note(f"Dolos compared {each.files} files: dolos serve {each.report}")
        elif each.why:
            note(f"Dolos made no report of {each.archive}: {each.why}")
        else:
            note(f"{each.files} files for Dolos: {each.archive}")
    if dolos() is None:
        note(f"Dolos is not installed here: {INSTALL}, and the same command once more")
    else:
        note("likeness is no proof: short solutions are often alike")


def _is_class_page(start: bytes) -> bool:
    from judge.report.html import is_page
    from judge.report.html.klass import CLASS_MARK

    return is_page(start, CLASS_MARK)


def _is_feedback(start: bytes) -> bool:
    from judge.report.html import is_page
    from judge.report.html.klass import FEEDBACK_MARK

    return is_page(start, FEEDBACK_MARK)


def _is_junit(start: bytes) -> bool:
    return b"<testsuite" in start
