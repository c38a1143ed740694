"""`judge new`, `judge verify` and `judge export`: write a kata, check it, and give it to other judges."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TypeVar

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cache import DISK
from judge.cli.files import writing
from judge.cli.options import Common, command, exclusive, opt, seconds_of
from judge.data.libraries import LibraryTable
from judge.data.load import load_data
from judge.errors import ProblemError, UsageError
from judge.files import replace_file
from judge.holes.hunt import look_for_holes
from judge.holes.model import Holes, HoleSearch
from judge.judging import RunOptions
from judge.judging.containment import contained, kept_level
from judge.packs.begin import KINDS, NewKata, begin_kata, begin_pack
from judge.packs.cases import group_files
from judge.packs.export import Exported, ExportOptions, check_options, export
from judge.packs.metadata import Version
from judge.practice.setter import kata_faults, verify_decks
from judge.problem import Problem
from judge.problem.find import find_problem, folders_within, problem_folders
from judge.problem.model import chosen_groups
from judge.report.published_setter import FilesWritten, VerifySummary
from judge.report.screen import note
from judge.report.wait import Stage, progress, stages
from judge.sandbox import Containment
from judge.verify.gate import Options, fresh_data, verify_problem
from judge.verify.libraries import measure_libraries
from judge.verify.model import Fault, Verified, fault_of
from judge.verify.solving import Solving

_Found = TypeVar("_Found")
_LOOK = 30.0  # seconds of a search for holes
_FORMS = PACKAGES, FILES = "kattis", "files"
_REMEDY = "name another folder with --out"


class NewAsk(Struct, frozen=True):
    """What to begin with."""

    like: str = opt("--like KIND", f"A kind of kata, {', '.join(KINDS)}; or a kata.", default="")
    pack: bool = opt("--pack", "A package for katas, to be installed, with none yet.")


@command("new", NewKata, ask=NewAsk)
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("name", metavar="[NAME]", required=False)
def new(folder: Path, name: str | None, ask: NewAsk, common: Common) -> NewKata:
    """Write a kata of your own to begin with.

    It goes into DIR/problems/NAME and DIR/solutions/NAME. If DIR is itself a folder of problems, it goes
    there. Without a NAME it is called as DIR is. The kata is complete, and judge verify finds it sound:
    change it file by file into yours. Nothing is ever written over.

    Exit status: 0 written, 2 usage.
    """
    if ask.pack:
        return begin_pack(folder, name)
    with stages(name or str(folder)) as tell:
        return begin_kata(folder, name, ask.like, common.problems, tell)


class VerifyAsk(Struct, frozen=True):
    """What to check of each kata."""

    matrix: bool = opt("--matrix", "Which groups find which mistake and reach which edge.")
    pin: bool = opt("--pin", "Pin the data as they are now: write pins.json.")
    figures: bool = opt("--figures", "Draw the statement's figure: write figure.svg.")
    seeds: int = opt(
        "--seeds N", "Check N sets of data, pinned ones first.", type=click.IntRange(1, 100), default=1
    )
    groups: tuple[str, ...] = opt("--group G", "Look at this group alone.", default=())
    libraries: bool = opt("--libraries", "Judge the kata's libraries, and write libraries.json.")
    solution: str = opt("--solution FILE", "Judge this solution alone, as accepted/exact.py.", default="")
    jobs: int = opt("-j --jobs N", "Check N katas at once.", type=click.IntRange(1, 64), default=1)
    holes: bool = opt("--holes", "Look for wrong programs that the data accept.")
    lasting: float | None = opt("--for TIME", "Look so long; 30s without it.", type=seconds_of)
    seed: int | None = opt("--seed N", "Look at other cases.")
    whole: bool = opt("--all", "List the accepted mutants without a witness, too.")


@command("verify", Verified, Holes, LibraryTable, ask=VerifyAsk)
@click.argument("names", metavar="[KATA]...", nargs=-1)
def verify(names: tuple[str, ...], ask: VerifyAsk, common: Common) -> Iterator[Struct]:
    """Check katas from the setter's side.

    Every case keeps the promise, the examples agree with the reference, the data are the pinned ones, every
    solution gets the verdict its folder says, hints can be read, a stub can be made, and the cards of judge
    quiz can be asked. Without a name: all that --problems gives, or all there is.

    With --group or --solution only a part is checked, as you work on it. With --libraries the adapters in
    solutions/KATA/libraries are judged instead, where their packages are found.

    With --holes right programs are changed in thousands of small ways instead. Those that the data accept
    are tried on cases of all kinds: one that is wrong on a valid case is a hole in the data. The same
    command goes on where it ended; Ctrl-C keeps what was found.

    Exit status: 0 sound, 2 usage, 3 something is wrong.
    """
    exclusive(ask, "pin", "groups", "solution", "libraries", "holes")
    exclusive(ask, "libraries", "groups", "solution", "matrix", "figures", "holes")
    exclusive(ask, "holes", "matrix", "figures")
    if not ask.holes and (ask.lasting or ask.seed is not None or ask.whole):
        raise UsageError("--for, --seed and --all are for --holes", remedy="add --holes")
    for name in names:
        with suppress(ProblemError):  # which is in the report then
            find_problem(name, common.problems)
    # without a name a setter means their own, not all that can be found
    mine = folders_within(common.problems) if common.problems else problem_folders()
    chosen = tuple(dict.fromkeys(names or sorted(folder.name for folder in mine)))
    if ask.holes:
        yield from _look(chosen, ask, common)
        return
    if ask.libraries:
        problems = [find_problem(name, common.problems) for name in chosen]
        yield from map(_libraries, [each for each in problems if (each.solutions / "libraries").is_dir()])
        return
    faults = 0
    for found in _each(partial(_verify, ask, common.problems), chosen, ask.jobs):
        if ask.figures and not found.faults:
            from judge.report.picture import figure

            problem = find_problem(found.problem, common.problems)
            if (drawn := figure(problem)) is not None:
                replace_file(problem.folder / "figure.svg", drawn.encode())
        faults += len(found.faults)
        yield found
    if not (ask.groups or ask.solution):
        decks = verify_decks(common.problems, names)
        faults += len(decks.faults)
        if decks.cards or decks.faults:
            yield decks
    if len(chosen) > 1:
        yield VerifySummary(len(chosen), faults)


def _each(work: Callable[[str], _Found], katas: Sequence[str], jobs: int) -> Iterator[_Found | Verified]:
    """What the work finds of each kata, in order; so many at once."""
    if jobs == 1 or len(katas) == 1:
        return map(work, katas)
    from judge.judging.pool import Processes, in_order

    return in_order(Processes(jobs), work, katas, lambda name, what: Verified(name, (Fault(what, name),)))


def _libraries(problem: Problem) -> LibraryTable:
    """The kata's libraries, measured."""
    with stages(problem.id) as advance:
        tell = advance or (lambda *_: None)
        return measure_libraries(problem, fresh_data(problem, tell), Containment(least=kept_level()), tell)


def _look(chosen: Sequence[str], ask: VerifyAsk, common: Common) -> Iterator[Struct]:
    """The holes of each kata."""
    faults = holes = 0
    try:
        for found in _each(partial(_holes, ask, common), chosen, ask.jobs):
            faults += len(found.faults)
            holes += len(found.holes) if isinstance(found, Holes) else 0
            listed = ask.whole or common.json or not isinstance(found, Holes)
            yield found if listed else replace(found, unwitnessed=())
            for said in found.notes if isinstance(found, Holes) else ():
                note(said)
            if isinstance(found, Holes) and found.stopped:
                raise KeyboardInterrupt
    except KeyboardInterrupt:
        note("stopped; what was found is kept, and the same command goes on")
        raise
    if len(chosen) > 1:
        yield VerifySummary(len(chosen), faults, holes)


def _holes(ask: VerifyAsk, common: Common, name: str) -> Holes | Verified:
    try:
        problem = find_problem(name, common.problems)
        groups = tuple([each for each in chosen_groups(problem, ask.groups) if each.size is None])
        if not groups:
            raise UsageError(f"{name} has only large cases in these groups", remedy="name another group")
        problem = replace(problem, groups=groups)  # large cases are neither asked nor changed
        with stages(name) as advance:
            sets = [fresh_data(problem, advance, seed) for seed in (None, *range(1, ask.seeds))]
            search = HoleSearch(ask.seed or 0, ask.lasting or _LOOK, program=ask.solution)
            boxes = contained(problem, RunOptions(isolation=common.isolation), ask.jobs)
            return look_for_holes(problem, sets, boxes, search, DISK, advance)
    except ProblemError as error:
        return Verified(name, (fault_of(error, name),))


def _verify(ask: VerifyAsk, folders: Sequence[Path], name: str) -> Verified:
    """What was found of one kata."""
    options = Options(ask.pin, ask.seeds, ask.groups, ask.solution, ask.matrix)
    at = "reading the kata"
    advance: Stage | None = None

    def say(text: str) -> None:
        if advance:
            advance("", 1, 1)  # takes the bar off
        note(f"{name}: {text}")

    solving = Solving(say)
    try:
        problem = find_problem(name, folders)
        with stages(name) as advance, solving:

            def tell(what: str, done: int, total: int) -> None:
                nonlocal at
                at = f"{what}, {done} of {total}"
                if advance:
                    advance(what, done, total)

            found = verify_problem(problem, options, tell, Containment(least=kept_level()), solving.within)
    except ProblemError as error:
        return Verified(name, (fault_of(error, name),))
    except KeyboardInterrupt:
        note(f"{name}: stopped while {solving.text or at}")
        raise
    return replace(found, faults=tuple(dict.fromkeys((*found.faults, *kata_faults(problem, folders)))))


class ExportAsk(Struct, frozen=True):
    """What to write."""

    out: Path = opt("--out DIR", "Where to write.", required=True)
    form: str = opt("--format", "Packages, or the data alone.", choices=_FORMS, default=PACKAGES)
    version: str | None = opt(
        "--version", "Of the packages' format; both without it.", choices=[each.value for each in Version]
    )
    archives: bool = opt("--zip", "Write archives too, one of them for DOMjudge.")
    wrong: int | None = opt(
        "--wrong N", "At most N wrong programs; with 0 only right and slow ones.", type=click.IntRange(0)
    )
    seed: int | None = opt("--seed N", "Files of other cases, from this seed, not the pinned ones.")
    force: bool = opt("--force", "Write over files that are there already.")


@command("export", Exported, FilesWritten, ask=ExportAsk)
@click.argument("names", metavar="KATA...", nargs=-1, required=True)
def write(names: tuple[str, ...], ask: ExportAsk, common: Common) -> Iterator[Struct]:
    """Write katas as packages or files that other judges read.

    Packages: DIR/legacy/ID and DIR/2025-09/ID are one package in two versions of the format, with the tests,
    a validator that decides as judge does, the statement as LaTeX, and the programs of solutions/. With
    --zip also DIR/*/ID.kpp, and DIR/domjudge/ID.zip. A package of the same kata is replaced.

    Files: DIR/KATA/G.in is what a program reads for the test group G, G.ans what a perfect one prints, and
    G.json holds every case with its exact answer and the least and greatest double that is accepted. A kata
    with a FORMAT has G-01.in and G-01.ans for each case.

    Exit status: 0 written, 2 usage, or nothing could be written, 3 a kata is broken.
    """
    exclusive(ask, "form", "version", "archives", "wrong")
    if ask.form == PACKAGES and (ask.force or ask.seed is not None):
        raise UsageError("--force and --seed are for --format files", remedy="add --format files")
    problems = [find_problem(name, common.problems) for name in dict.fromkeys(names)]
    return _files(problems, ask) if ask.form == FILES else _packages(problems, ask)


def _packages(problems: Sequence[Problem], ask: ExportAsk) -> Iterator[Exported]:
    """The packages of each; one whose folder is broken costs itself only."""
    versions = (Version(ask.version),) if ask.version else tuple(Version)
    options = ExportOptions(ask.out, versions, ask.archives, ask.wrong)
    check_options(problems, options)
    boxes, written, broken = Containment(least=kept_level()), False, None
    for each in problems:
        try:
            with stages(each.id) as advance:
                found = export(each, options, boxes, advance or (lambda *_: None))
        except ProblemError as fault:
            broken, found = fault, Exported(each.id, left_out=str(fault))
        written |= found.left_out is None
        yield found
    if broken is not None:
        raise broken
    if not written:
        raise UsageError(f"No package can hold {'it' if len(problems) == 1 else 'any of these'}")


def _files(problems: Sequence[Problem], ask: ExportAsk) -> Iterator[FilesWritten]:
    """The data of each, three files a group; only with --force into a folder that holds some."""
    for each in problems:
        target = ask.out / each.id
        with writing(target, _REMEDY):
            target.mkdir(parents=True, exist_ok=True)
            if any(target.iterdir()) and not ask.force:
                raise UsageError(f"{target} is not empty", remedy="name an empty folder or add --force")
    for each in problems:
        target = ask.out / each.id
        with progress(f"building {each.id}") as advance:
            data = load_data(each, seed=ask.seed, progress=advance)
        for said in data.notes:
            note(said)
        names: list[str] = []
        for group in data.groups:
            for name, content in group_files(data, group).items():
                with writing(target / name, _REMEDY):
                    replace_file(target / name, content)
                names.append(name)
        cases = sum(len(group.cases) for group in data.groups)
        yield FilesWritten(each.id, str(target), cases, tuple(names))
