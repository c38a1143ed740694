"""Exporting one problem: what is to be written, and what came of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from msgspec import Struct

from judge.data.load import load_data
from judge.errors import UsageError
from judge.packs.cases import Test, tests_in
from judge.packs.driver import why_not_alone
from judge.packs.metadata import UNKNOWN, Version, license_of, short_name, uuid_of
from judge.packs.package import Contents, zipped
from judge.packs.programs import SURELY, Exporter, Held, LeftOut, Programs
from judge.packs.schemas import NoForm, check_forms, is_judged, whole_output
from judge.packs.statement import latex
from judge.packs.write import check_archive, check_folder, write_archive, write_folder
from judge.problem import Problem, Verdict
from judge.problem.declare import __all__ as declared
from judge.published import Published
from judge.sandbox.boundary import BoxFactory

Progress = Callable[[str, int, int], None]

_ARCHIVE = ".kpp"


class Order(Struct, frozen=True):
    """What to write: `wrong` bounds how many mistakes the packages hold programs of."""

    out: Path
    versions: tuple[Version, ...]
    archives: bool = False
    wrong: int | None = None

    def folder(self, problem: Problem, version: Version) -> Path:
        """Where a problem's package goes; its archive lies beside it."""
        return self.out / version.value / short_name(problem.id)

    def domjudge(self, problem: Problem) -> Path:
        """Where the archive for DOMjudge goes."""
        return self.out / "domjudge" / f"{short_name(problem.id)}.zip"


class Package(Struct, frozen=True):
    """One package that was written; `archive` is None where none was asked for."""

    version: Version
    folder: Path
    archive: Path | None
    files: int
    bytes: int


class Exported(Published, frozen=True):
    """The packages of a problem; `left_out` says why there are none."""

    problem: str
    left_out: str | None = None
    packages: tuple[Package, ...] = ()
    domjudge: Path | None = None
    time_limit: int | None = None
    programs: tuple[Held, ...] = ()
    programs_left_out: tuple[LeftOut, ...] = ()
    notes: tuple[str, ...] = ()


def check_order(problems: Sequence[Problem], order: Order) -> None:
    """Raises UsageError where these cannot be written, before anything takes long."""
    owners: dict[str, str] = {}
    for problem in problems:
        short = short_name(problem.id)
        owner = owners.setdefault(short, problem.id)
        if owner != problem.id:
            what = f"{owner} and {problem.id} would both be the package {short}"
            raise UsageError(what, remedy="export them into different folders")
    for problem in problems:
        _check_places(problem, order)


def _check_places(problem: Problem, order: Order) -> None:
    """Raises UsageError where something else is where a package is to be written."""
    for version in order.versions:
        folder, uuid = order.folder(problem, version), uuid_of(problem.id, version)
        check_folder(folder, uuid)
        if order.archives:
            check_archive(folder.with_suffix(_ARCHIVE), uuid)
    if order.archives:
        check_archive(order.domjudge(problem), uuid_of(problem.id, Version.LEGACY))


def export(problem: Problem, order: Order, boxes: BoxFactory, progress: Progress) -> Exported:
    """Write a problem's packages. Raises JudgeError: ProblemError for its data, UsageError for a place."""
    large: list[str] = []
    try:
        check_forms(problem)
        data = load_data(problem, progress=lambda done, total: progress("building data", done, total))
        tests = tuple(tests_in(data, large))
        brought = _brought(problem, tests)
    except NoForm as why:
        return Exported(problem.id, str(why))
    programs = Exporter(data, tests, boxes, progress).programs(order.wrong)
    contents = Contents(problem, tests, programs, latex(problem), brought)
    _check_places(problem, order)
    packages, domjudge = [], None
    for version in order.versions:
        folder, files, archive = order.folder(problem, version), contents.files(version), None
        write_folder(folder, files)
        if order.archives:
            archive = folder.with_suffix(_ARCHIVE)
            write_archive(archive, zipped(files, folder.name))
        packages.append(Package(version, folder, archive, len(files), sum(map(len, files.values()))))
    if order.archives:
        domjudge = order.domjudge(problem)
        write_archive(domjudge, zipped(contents.domjudge()))
    return Exported(
        problem.id,
        packages=tuple(packages),
        domjudge=domjudge,
        time_limit=programs.seconds,
        programs=programs.held,
        programs_left_out=programs.left_out,
        notes=(*_notes(problem, programs), *(f"left out: {each}" for each in large)),
    )


def _brought(problem: Problem, tests: Sequence[Test]) -> bytes:
    """The problem.py that the output validator asks; empty where it needs none. Raises NoForm."""
    if (
        not problem.talks
        and whole_output(problem) != "read"
        and not any(is_judged(test.accepted) for test in tests)
    ):
        return b""
    source = (problem.folder / "problem.py").read_bytes()
    if why := why_not_alone(source.decode("utf-8-sig"), declared):
        raise NoForm(f"its checker {why.removeprefix('it ')}")
    return source


def _notes(problem: Problem, programs: Programs) -> Iterator[str]:
    """What a person should know of the package."""
    if problem.source.license and license_of(problem.source) == UNKNOWN:
        yield f"packages know no license {problem.source.license}: it is 'unknown' there"
    for each in programs.held:
        if each.verdict is Verdict.TLE:
            yield f"{each.file} takes more than {SURELY * programs.seconds} s of {programs.seconds} s"
    if not any(each.verdict is Verdict.AC for each in programs.held):
        yield "it holds no accepted program, and the tools want one"
