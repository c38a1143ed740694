"""`judge run PACKAGE`: submissions judged on a package of another judge, or those of the package itself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

from msgspec import Struct

from judge.cli.options import write_json
from judge.cli.submissions import gathered
from judge.errors import ExitCode, ProblemError, UsageError
from judge.folders import cache_folder
from judge.judging.containment import WEAK
from judge.judging.isolation import kept_level
from judge.packs.foreign.cases import test_files
from judge.packs.foreign.checker import Checker, content_of
from judge.packs.foreign.expected import FOLDER, Demand, Own, own_submissions, tagged
from judge.packs.foreign.judging import Court, Judged, Seen, unjudged
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import OURS, Bounds, Package, read_package
from judge.packs.foreign.programs import Content, NotRunError, Program, is_one_program, program_of
from judge.packs.foreign.timing import ACCEPTED, UNKNOWN, TimeLimit, found_limit
from judge.problem.verdict import Verdict
from judge.report.live import Live
from judge.report.screen import note, out
from judge.report.values import counted
from judge.sandbox import Boxes, room


class Asked(Struct, frozen=True):
    """What a person asks of a package: the files, or its `own` submissions, and how they are told of it."""

    word: str
    files: tuple[str, ...] = ()
    own: bool = False
    as_json: bool = False
    brief: bool = False
    level: str | None = None
    bounds: Bounds = OURS
    follow: bool = False


class Entrant(Struct, frozen=True):
    """A submission before it is judged: its program, or why it is none.

    `demands` are what is asked of one of the package's own, in that `folder`.
    """

    name: str
    program: Program | None = None
    why: str = ""
    folder: str = ""
    demands: tuple[Demand, ...] | None = None


class Ruled(Struct, frozen=True):
    """A submission with its result; `as_expected` is None where nothing is expected of it."""

    entrant: Entrant
    judged: Judged
    as_expected: bool | None = None


def run_package(asked: Asked) -> ExitCode:
    """Judge what is asked for, and write it.

    Raises:
        UsageError: the package is of a kind that is not judged here, or a file is missing.
        ProblemError: the package is broken.
        JudgeError: nothing can be run here.
    """
    if asked.own == bool(asked.files):
        what = "name files to judge, or its own submissions with --all"
        remedy = "leave one out" if asked.own else f"judge run {asked.word} FILE"
        raise UsageError(what, where=asked.word, remedy=remedy)
    with Opened(asked.word) as opened:
        package = read_package(opened, asked.bounds)
        tests = test_files(package)
        for text in package.lowered.values():
            note(text)
        room.raise_descriptors()
        hidden = [opened.root, _cache()]
        boxes = Boxes(asked.level, hidden, least=None if asked.level else kept_level())
        entrants = list(_owns(package)) if asked.own else list(_named(asked.files, follow=asked.follow))
        with Checker(package, boxes) as checker:
            sitting = _Sitting(Court(package, tests, checker, boxes), asked)
            return sitting.judge_all(entrants)


def _cache() -> Path:
    """The cache, made first, or it could not be covered."""
    cache = cache_folder()
    with suppress(OSError):
        cache.mkdir(parents=True, exist_ok=True)
    return cache


class _Sitting:
    """The submissions of one command, judged one after another: each is timed."""

    def __init__(self, court: Court, asked: Asked) -> None:
        self._court = court
        self._asked = asked
        self._known: dict[str, Judged] = {}  # accepted ones, by name, whose time the limit follows from
        self._unset = "the package has no accepted submission"  # why no time limit follows from them
        self._live = Live(silent=asked.brief)

    def judge_all(self, entrants: Sequence[Entrant]) -> ExitCode:
        package, asked = self._court.package, self._asked
        level = self._court.boxes.first()
        limit = found_limit(package, level, self._slowest)
        if limit.lowered:
            note(f"{limit.lowered}; --package-limits allows more")
        if limit is UNKNOWN and not self._court.checker.hung:
            note(f"{self._unset} to set the time limit: it is {limit.seconds:g} s")
        rows: list[Ruled] = []
        interrupted = False
        try:
            for place, entrant in enumerate(entrants):
                with self._live:
                    rows.append(self._ruled(entrant, limit, f"{place} of {len(entrants)} judged, "))
                self._show(rows[-1], limit, several=len(entrants) > 1)
        except KeyboardInterrupt:
            if not rows or asked.as_json:
                raise
            interrupted = True
        if not asked.as_json:
            from judge.cli.package_screen import end_lines

            out().show(end_lines(package, rows, len(entrants), limit, out().width, own=asked.own))
            if asked.brief and len(entrants) == 1 and rows[0].judged.verdict is Verdict.JE:
                assert rows[0].judged.failure is not None
                note(rows[0].judged.failure.message)
        if any(row.judged.isolation == "limits" for row in rows) and asked.level is None:
            note(WEAK)
        return ExitCode.INTERRUPTED if interrupted else _exit_code(rows, own=asked.own)

    def _slowest(self) -> float | None:
        """CPU seconds of the slowest of the package's accepted submissions.

        None where none is, and after the first that is too slow: the others would change nothing.
        """
        owns = list(_owns(self._court.package, ACCEPTED))
        if owns:
            self._unset = "it accepts none of them"
            many = counted(len(owns), "accepted submission")
            note(f"the time limit follows from {many}, judged first")
        for entrant in owns:
            if entrant.program is not None:
                with self._live:
                    judged = self._court.judged(entrant.program, UNKNOWN, seen=self._seen(entrant))
                if judged.verdict is Verdict.AC:
                    self._known[entrant.name] = judged
                elif judged.verdict is Verdict.TLE and judged.failure is not None:
                    self._unset = f"{entrant.name} is too slow on {judged.failure.test}"
                    return None
        return max((judged.slowest for judged in self._known.values()), default=None)

    def _seen(self, entrant: Entrant, before: str = "") -> Seen:
        """What shows how far a submission is."""
        many = len(self._court.tests)
        return lambda count, name: self._live.show(
            lambda: f"{before}{entrant.name} on {name}, {count} of {counted(many, 'test file')}"
        )

    def _ruled(self, entrant: Entrant, limit: TimeLimit, before: str) -> Ruled:
        demands = entrant.demands
        if entrant.program is None:
            judged = unjudged(entrant.name, entrant.why)
            return Ruled(entrant, judged)
        judged = (self._asked.own and self._known.get(entrant.name)) or self._court.judged(
            entrant.program,
            limit,
            lambda verdicts: any(demand.goes_on(verdicts) for demand in demands or ()),
            self._seen(entrant, before),
        )
        if not demands:
            return Ruled(entrant, judged)
        verdicts = [test.verdict for test in judged.tests]
        return Ruled(entrant, judged, all(demand.met(judged.verdict, verdicts) for demand in demands))

    def _show(self, ruled: Ruled, limit: TimeLimit, *, several: bool) -> None:
        if self._asked.as_json:
            from judge.cli.package_json import row_object

            write_json(row_object(self._court.package, ruled, limit))
        elif not self._asked.brief:
            from judge.cli.package_screen import row_lines

            out().show(row_lines(self._court.package, ruled, out().width, several=several))


def _exit_code(rows: Sequence[Ruled], *, own: bool) -> ExitCode:
    """A fault weighs most; then what is not accepted, or of the package's own what is not as expected."""
    if any(row.judged.verdict is Verdict.JE for row in rows):
        return ExitCode.FAULT
    right = all(row.as_expected is not False if own else row.judged.verdict is Verdict.AC for row in rows)
    return ExitCode.ACCEPTED if right else ExitCode.NOT_ACCEPTED


def _owns(package: Package, folder: str = "") -> Iterator[Entrant]:
    """The package's own submissions. Raises ProblemError where there are none."""
    found = own_submissions(package, folder)
    if not found and not folder:
        raise ProblemError(f"there is nothing in {FOLDER}/", where=package.name)
    for own in found:
        yield _entrant_of(package, own)


def _entrant_of(package: Package, own: Own) -> Entrant:
    try:
        content = content_of(package.opened, own.path)
        own = tagged(own, content)
        program = program_of(own.name, content)
    except NotRunError as fault:
        return Entrant(own.name, None, str(fault), own.folder, own.demands)
    except ProblemError as fault:
        return Entrant(own.name, None, fault.what, own.folder, own.demands)
    return Entrant(own.name, program, "", own.folder, own.demands)


def _named(files: Sequence[str], *, follow: bool) -> Iterator[Entrant]:
    """The files that a person names; a folder is one program, or stands for the programs in it.

    Raises UsageError where one is missing, and for the only one that cannot be run.
    """
    names = list(dict.fromkeys(files))
    programs = {name: content for name in names if (content := _one_program(name))}
    others = [name for name in names if name not in programs]
    submissions, unread = gathered(others, follow=follow) if others else ([], [])
    if len(submissions) + len(unread) + len(programs) == 1 and submissions:
        _check_alone(submissions[0].name, submissions[0].source)
    for name, content in programs.items():
        yield _entrant(name, content)
    for submission in submissions:
        yield _entrant(submission.name, [(Path(submission.name).name, submission.source)])
    for each in unread:
        yield Entrant(each.name, None, each.why)


def _check_alone(name: str, source: bytes) -> None:
    try:
        program_of(name, [(Path(name).name, source)])
    except NotRunError as fault:
        raise UsageError(str(fault), where=name) from None


def _one_program(name: str) -> Content | None:
    """The files of a folder that is one program; None where it is none."""
    if not Path(name).is_dir():
        return None
    try:
        opened = Opened(name)
        content = content_of(opened, opened.root)
    except ProblemError:  # more than a program has: whoever goes through its files says so
        return None
    return content if is_one_program(content) else None


def _entrant(name: str, content: Content) -> Entrant:
    try:
        return Entrant(name, program_of(name, content))
    except NotRunError as fault:
        return Entrant(name, None, str(fault))
