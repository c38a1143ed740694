"""Exporting one problem: what is to be written, and what came of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct

from judge.data.load import load_data
from judge.errors import UsageError
from judge.packs.cases import Test, tests_in
from judge.packs.driver import why_not_alone
from judge.packs.metadata import UNKNOWN, Version, license_of, short_name, uuid_of
from judge.packs.package import Contents, zipped
from judge.packs.programs import SURELY, Excluded, Exporter, Included, Programs, Progress
from judge.packs.schemas import NotExportable, check_forms, is_judged, whole_output
from judge.packs.write import check_place, write_archive, write_folder
from judge.problem import Problem, Verdict
from judge.problem.declare import __all__ as declared
from judge.published import Published
from judge.sandbox.boundary import BoxFactory


class ExportOptions(Struct, frozen=True):
    """What to write: `wrong` bounds how many mistakes the packages hold programs of."""

    out: Path
    versions: tuple[Version, ...]
    archives: bool = False
    wrong: int | None = None

    def folder(self, problem: Problem, version: Version) -> Path:
        """Where a problem's package goes."""
        return self.out / version.value / short_name(problem.id)

    def domjudge(self, problem: Problem) -> Path:
        """Where the archive for DOMjudge goes, if one is wanted."""
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
    programs: tuple[Included, ...] = ()
    programs_left_out: tuple[Excluded, ...] = ()
    notes: tuple[str, ...] = ()


def check_options(problems: Sequence[Problem], options: ExportOptions) -> None:
    """Raises UsageError where these cannot be written, before anything takes long."""
    owners: dict[str, str] = {}
    for problem in problems:
        short = short_name(problem.id)
        owner = owners.setdefault(short, problem.id)
        if owner != problem.id:
            what = f"{owner} and {problem.id} would both be the package {short}"
            raise UsageError(what, remedy="export them into different folders")
        _check_places(problem, options)


def _check_places(problem: Problem, options: ExportOptions) -> None:
    """Raises UsageError where something else is where a package is to be written."""
    for version in options.versions:
        folder, uuid = options.folder(problem, version), uuid_of(problem.id, version)
        check_place(folder, uuid)
        if options.archives:
            check_place(folder.with_suffix(".kpp"), uuid)
    if options.archives:
        check_place(options.domjudge(problem), uuid_of(problem.id, Version.LEGACY))


def export(problem: Problem, options: ExportOptions, boxes: BoxFactory, progress: Progress) -> Exported:
    """Write a problem's packages. Raises JudgeError: ProblemError for its data, UsageError for a place."""
    from judge.packs.statement import latex  # which reads Markdown; no other command of setters does

    large: list[str] = []
    try:
        check_forms(problem)
        data = load_data(problem, progress=lambda done, total: progress("building data", done, total))
        tests = tuple(tests_in(data, large))
        brought = brought_along(problem, tests)
    except NotExportable as why:
        return Exported(problem.id, str(why))
    programs = Exporter(data, tests, boxes, progress).programs(options.wrong)
    contents = Contents(problem, tests, programs, latex(problem), brought)
    _check_places(problem, options)
    domjudge = options.domjudge(problem) if options.archives else None
    if domjudge:
        write_archive(domjudge, zipped(contents.domjudge()))
    return Exported(
        problem.id,
        packages=tuple(_written(contents, version, options) for version in options.versions),
        domjudge=domjudge,
        time_limit=programs.seconds,
        programs=programs.included,
        programs_left_out=programs.excluded,
        notes=(*_notes(problem, programs), *(f"left out: {each}" for each in large)),
    )


def _written(contents: Contents, version: Version, options: ExportOptions) -> Package:
    """The package in that version, once it is there. Raises UsageError."""
    folder, files, archive = options.folder(contents.problem, version), contents.files(version), None
    write_folder(folder, files)
    if options.archives:
        archive = folder.with_suffix(".kpp")
        write_archive(archive, zipped(files, folder.name))
    return Package(version, folder, archive, len(files), sum(map(len, files.values())))


def brought_along(problem: Problem, tests: Sequence[Test]) -> bytes:
    """The problem.py that a validator asks; empty where it needs none. Raises NotExportable."""
    judged = any(is_judged(test.accepted) for test in tests)
    if not judged and whole_output(problem) not in ("read", "talk"):
        return b""
    source = (problem.folder / "problem.py").read_bytes()
    if why := why_not_alone(source.decode("utf-8-sig"), declared):
        raise NotExportable(f"its checker {why.removeprefix('it ')}")
    return source


def _notes(problem: Problem, programs: Programs) -> Iterator[str]:
    """What a person should know of the package."""
    if problem.source.license and license_of(problem.source) == UNKNOWN:
        yield f"packages know no license {problem.source.license}: it is 'unknown' there"
    for each in programs.included:
        if each.verdict is Verdict.TLE:
            yield f"{each.file} takes more than {SURELY * programs.seconds} s of {programs.seconds} s"
    if not any(each.verdict is Verdict.AC for each in programs.included):
        yield "it holds no accepted program, and the tools want one"
