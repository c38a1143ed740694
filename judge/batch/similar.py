"""What Dolos reads, a detector of similar programs by Ghent University, and calling it where it is installed.

    <folder>.judge.similar/
        count-python.zip           info.csv and the files, as Dolos and its web page take them
        count-python.stub.py       what everybody was given, which Dolos leaves out
        count-python-report/       Dolos' report; `dolos serve` shows it

A file is called within the archive by a number and its own ending alone: what students call theirs is text of
info.csv. Whether programs are alike is Dolos' measure, and what it means is for a person to say.
"""

from __future__ import annotations

import io
import shutil
import subprocess
import zipfile
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePath

from msgspec import Struct

from judge.atomic import replace_file
from judge.batch.model import Handin
from judge.batch.outcome import Outcome, counting
from judge.errors import ProblemError, unwritable
from judge.kata.stub import make_stub
from judge.languages import NAME, SUFFIX, language_of
from judge.problem import Problem
from judge.report.layout import printable
from judge.report.sheet import csv_text

INSTALL = "npm install -g @dodona/dolos"
_SECONDS = 900  # that Dolos may take for one archive
_HEAD = ("filename", "full_name", "labels", "student", "file")
_EPOCH = (1980, 1, 1, 0, 0, 0)  # of every file in an archive: the same class gives the same bytes


class Compared(Struct, frozen=True):
    """One archive: of so many files; its `report` is None where Dolos made none, and `why` says why not."""

    archive: Path
    files: int
    report: Path | None = None
    why: str = ""


def similar_folder(store: Path) -> Path:
    """Where this is written: beside the file of results."""
    return store.with_name(f"{store.name.removesuffix('.sqlite3').removesuffix('.judge')}.judge.similar")


def dolos() -> str | None:
    """Where the command is, if it is installed."""
    return shutil.which("dolos")


def compared(
    folder: Path, outcome: Outcome, handins: Iterable[Handin], problems: Mapping[str, Problem]
) -> list[Compared]:
    """Write an archive for each problem and language that two students have files of, and have Dolos read it.

    The files that count are compared, one a student. Raises UsageError where nothing can be written.
    """
    counts = {row.file for row in counting(outcome.rows).values()}
    people = {each.id: each for each in outcome.students}
    own: dict[tuple[str, str], list[Handin]] = defaultdict(list)
    for each in handins:
        if each.source and each.file in counts:
            own[each.problem, _language(each.file)].append(each)
    told = []
    for (problem, language), files in sorted(own.items()):
        if len(files) < 2:
            continue
        rows = [(each, people[each.student].name, people[each.student].group) for each in files]
        archive = folder / f"{problem}-{language}.zip"
        stub = _stub(problems.get(problem)) if language == NAME.lower() else b""
        _write(archive, archive_of(rows))
        if stub:
            _write(archive.with_suffix(f".stub{SUFFIX}"), stub)
        told.append(_run(archive, len(files), stub=bool(stub)))
    return told


def archive_of(rows: Sequence[tuple[Handin, str, str]]) -> bytes:
    """The archive of these hand-ins, each with its author's name and group."""
    table, packed = [list(_HEAD)], io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for number, (each, name, group) in enumerate(rows, 1):
            inside = f"{number:04}{''.join(PurePath(each.file).suffixes[-1:])}"
            table.append([inside, name or each.student, group, each.student, each.file])
            archive.writestr(zipfile.ZipInfo(inside, _EPOCH), each.source)
        info = csv_text(table, "\n").encode("utf-8", "backslashreplace")
        archive.writestr(zipfile.ZipInfo("info.csv", _EPOCH), info)
    return packed.getvalue()


def _language(file: str) -> str:
    language = None if file.endswith(SUFFIX) else language_of(file)  # PyPy's is Python too
    return language.id if language else NAME.lower()


def _stub(problem: Problem | None) -> bytes:
    try:
        return make_stub(problem).encode() if problem else b""
    except ProblemError:
        return b""


def _write(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(exist_ok=True)
        replace_file(path, content)
    except OSError as fault:
        raise unwritable(path, fault, "write the results elsewhere with --out") from fault


def _run(archive: Path, files: int, *, stub: bool) -> Compared:
    """Have Dolos make its report of an archive, in a folder that is new."""
    command = dolos()
    if command is None:
        return Compared(archive, files)
    report = _new_folder(archive)
    ignored = ["--ignore", archive.with_suffix(f".stub{SUFFIX}").name] if stub else []
    words = [command, "run", "--output-format", "csv", "--output-destination", report.name]
    try:
        ended = subprocess.run(
            [*words, *ignored, archive.name],
            cwd=archive.parent,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Compared(archive, files, why=f"it did not end within {_SECONDS // 60} minutes")
    except OSError as fault:
        return Compared(archive, files, why=f"it cannot be started ({fault.strerror})")
    if ended.returncode or not report.is_dir():
        said = (ended.stderr or ended.stdout).decode(errors="replace").strip().splitlines()
        return Compared(archive, files, why=printable(said[-1])[:300] if said else "it made no report")
    return Compared(archive, files, report)


def _new_folder(archive: Path) -> Path:
    """A folder that is not there yet: Dolos writes into none that is."""
    report, number = archive.with_name(f"{archive.stem}-report"), 1
    while report.exists():
        number += 1
        report = archive.with_name(f"{archive.stem}-report-{number}")
    return report
