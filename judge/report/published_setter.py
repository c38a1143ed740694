"""What new, verify, export and doctor say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.errors import ExitCode
from judge.languages.find import Found
from judge.mistakes.verified import ChoicesReport
from judge.packs.export.job import Export, Package
from judge.packs.export.programs import LeftOut
from judge.problem import Verdict
from judge.report.views import Published, copied
from judge.run.verify import Fault, VerifyReport
from judge.sandbox.probe import Level


class NewKata(Published, frozen=True):
    """A kata that was written: its folder of problems, and its files."""

    problem: str
    title: str
    problems: str
    files: tuple[str, ...]


class SolutionRow(Struct, frozen=True):
    """A file of solutions/: its verdict, null where it is `unjudged`, and the groups that it fails."""

    file: str
    name: str
    verdict: Verdict | None
    ok: bool
    failed: tuple[str, ...]
    unjudged: str


class MistakeRow(Struct, frozen=True):
    """A mistake: its line of mistakes.py, the group that finds it in most cases, and all that find it."""

    name: str
    line: str
    group: str
    cases: int
    groups: tuple[str, ...]


class EdgeRow(Struct, frozen=True):
    """How many cases reach an edge of what may come."""

    what: str
    cases: int


class Verified(Published, frozen=True):
    """What was checked of a kata, and what is wrong."""

    problem: str
    ok: bool
    groups: int
    cases: int
    pins: str
    solutions: tuple[SolutionRow, ...]
    mistakes: tuple[MistakeRow, ...]
    edges: tuple[EdgeRow, ...]
    faults: tuple[Fault, ...]
    warnings: tuple[Fault, ...]

    @property
    def exit_code(self) -> ExitCode:
        """3 where something is wrong."""
        return ExitCode.ACCEPTED if self.ok else ExitCode.FAULT


def verified(report: VerifyReport, choices: ChoicesReport | None = None) -> Verified:
    """What is published of a report, and of what came of the problem's mistakes.py."""
    choices = choices or ChoicesReport()
    found = {
        each.name: copied(
            MistakeRow, each, groups=tuple(at for at, names in choices.kills.items() if each.name in names)
        )
        for each in sorted(choices.least, key=lambda least: (least.name, -least.cases))
    }
    return copied(
        Verified,
        report,
        solutions=tuple(copied(SolutionRow, each) for each in report.solutions),
        mistakes=tuple(found.values()),
        edges=tuple(EdgeRow(*each) for each in report.edges),
    )


class DecksVerified(Published, frozen=True):
    """How many cards of `judge quiz` were checked, and what is wrong with them."""

    cards: int
    faults: tuple[Fault, ...]

    @property
    def exit_code(self) -> ExitCode:
        """3 where something is wrong."""
        return ExitCode.FAULT if self.faults else ExitCode.ACCEPTED


class VerifySummary(Struct, frozen=True):
    """What all of it comes to; nothing of it is in the JSON."""

    katas: int
    faults: int
    published: tuple[()] = ()


class FilesWritten(Published, frozen=True):
    """A kata's data as files of a folder: three for each group."""

    problem: str
    out: str
    cases: int
    files: tuple[str, ...]


class ProgramRow(Struct, frozen=True):
    """A program of the packages: its verdict there, and the test that decides it."""

    file: str
    verdict: Verdict
    test: str | None


class Exported(Published, frozen=True):
    """The packages of a kata; `left_out` says why there are none."""

    problem: str
    package: str
    left_out: str | None
    packages: tuple[Package, ...]
    domjudge: Path | None
    time_limit: int | None
    programs: tuple[ProgramRow, ...]
    programs_left_out: tuple[LeftOut, ...]
    notes: tuple[str, ...]


def exported(found: Export) -> Exported:
    """What is published of an export."""
    programs = found.programs
    return Exported(
        found.problem.id,
        found.short,
        found.why or None,
        packages=found.packages,
        domjudge=found.domjudge,
        time_limit=programs.seconds if programs else None,
        programs=tuple(
            ProgramRow(each.path, each.trial.verdict, each.trial.file or None)
            for each in (programs.held if programs else ())
        ),
        programs_left_out=programs.left_out if programs else (),
        notes=found.notes,
    )


class AttackRow(Struct, frozen=True):
    """A harmless attack: what it tries, whether it was held, and how."""

    name: str
    tries: str
    held: bool
    how: str


class Attacks(Struct, frozen=True):
    """What came of the attacks at a level of isolation."""

    isolation: str
    attacks: tuple[AttackRow, ...]


class Doctor(Published, frozen=True):
    """What this machine gives; `isolation` is the best level, null where nothing can be run."""

    isolation: str | None
    levels: tuple[Level, ...]
    languages: tuple[Found, ...]
    attacks: Attacks | None
    judge: str
    python: str
    system: str
    cores: int
    cache: str

    @property
    def exit_code(self) -> ExitCode:
        """1 where an attack was not held."""
        held = self.attacks is None or all(each.held for each in self.attacks.attacks)
        return ExitCode.ACCEPTED if held else ExitCode.NOT_ACCEPTED


class SiteBuilt(Published, frozen=True):
    """What came of a build: katas made now, those that were there, those for the terminal, all bytes."""

    out: str
    made: tuple[str, ...]
    kept: tuple[str, ...]
    elsewhere: tuple[str, ...]
    bytes: int
    opened: bool
