"""Exporting one problem: what is to be written, and what came of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from msgspec import Struct

from judge.data.load import load_data
from judge.packs.export.cases import tests_in
from judge.packs.export.forms import NoForm
from judge.packs.export.metadata import Version, license_of, short_name, uuid_of
from judge.packs.export.package import Contents, Files, zipped
from judge.packs.export.place import check_archive, check_folder, write_archive, write_folder
from judge.packs.export.programs import Exporter, LeftOut, Programs
from judge.packs.export.statement import latex
from judge.problem import Problem, Verdict
from judge.sandbox.boundary import BoxFactory

Progress = Callable[[str, int, int], None]

DOMJUDGE = "domjudge"  # the folder of archives that DOMjudge imports


class Order(Struct, frozen=True):
    """What to write: `held` says that programs belong to it, `wrong` bounds how many mistakes."""

    out: Path
    versions: tuple[Version, ...]
    archives: bool = False
    held: bool = True
    wrong: int | None = None


class Package(Struct, frozen=True):
    """One package that was written; `archive` is None where none was asked for."""

    version: Version
    folder: Path
    archive: Path | None
    files: int
    bytes: int


class Held(Struct, frozen=True):
    """A program of the packages: its verdict there, and the test that decides it."""

    file: str
    verdict: Verdict
    test: str | None


class Export(Struct, frozen=True):
    """The packages of a problem; `left_out` says why there are none."""

    problem: str
    package: str
    left_out: str | None = None
    packages: tuple[Package, ...] = ()
    domjudge: Path | None = None
    time_limit: int | None = None
    programs: tuple[Held, ...] = ()
    programs_left_out: tuple[LeftOut, ...] = ()
    notes: tuple[str, ...] = ()


def places(problem: Problem, order: Order) -> tuple[dict[Version, tuple[Path, Path]], Path]:
    """Where a problem's packages and their archives go, and the archive for DOMjudge."""
    short = short_name(problem.id)
    found = {
        version: (order.out / version.value / short, order.out / version.value / f"{short}.kpp")
        for version in order.versions
    }
    return found, order.out / DOMJUDGE / f"{short}.zip"


def check_places(problem: Problem, order: Order) -> None:
    """Raises UsageError where something else is where a package is to be written."""
    packages, domjudge = places(problem, order)
    for version, (folder, archive) in packages.items():
        check_folder(folder, uuid_of(problem.id, version))
        if order.archives:
            check_archive(archive, uuid_of(problem.id, version))
    if order.archives:
        check_archive(domjudge, uuid_of(problem.id, Version.LEGACY))


def export(problem: Problem, order: Order, boxes: BoxFactory, progress: Progress) -> Export:
    """Write a problem's packages. Raises JudgeError: ProblemError for its data, UsageError for a place."""
    short = short_name(problem.id)
    data = load_data(problem, progress=lambda done, total: progress("building data", done, total))
    try:
        tests = tuple(tests_in(data))
    except NoForm as why:
        return Export(problem.id, short, str(why))
    programs = Exporter(data, tests, boxes).programs(progress, held=order.held, wrong=order.wrong)
    contents = Contents(problem, tests, programs, latex(problem))
    check_places(problem, order)
    where, domjudge = places(problem, order)
    packages = []
    for version, (folder, archive) in where.items():
        files = contents.files(version)
        _write(folder, archive if order.archives else None, files)
        size = sum(map(len, files.values()))
        packages.append(Package(version, folder, archive if order.archives else None, len(files), size))
    if order.archives:
        write_archive(domjudge, zipped(contents.domjudge()))
    return Export(
        problem.id,
        short,
        packages=tuple(packages),
        domjudge=domjudge if order.archives else None,
        time_limit=programs.seconds,
        programs=tuple(
            Held(each.path, each.trial.verdict, each.trial.file or None) for each in programs.held
        ),
        programs_left_out=programs.left_out,
        notes=tuple(_notes(problem, programs)),
    )


def _write(folder: Path, archive: Path | None, files: Files) -> None:
    write_folder(folder, files)
    if archive is not None:
        write_archive(archive, zipped(files, folder.name))


def _notes(problem: Problem, programs: Programs) -> Sequence[str]:
    """What a person should know of the package."""
    found = []
    if problem.source.license and license_of(problem.source) == "unknown":
        found.append(f"packages know no license {problem.source.license}: it is 'unknown' there")
    if programs.held and not any(each.path.startswith("accepted/") for each in programs.held):
        found.append("it holds no accepted program, and the tools want one")
    return found
