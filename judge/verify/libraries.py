"""Measuring what real libraries answer to a kata: solutions/<id>/libraries/NAME.py, as a user calls them.

No verdict is wanted of them; what they come to is kept by judge.data.libraries.
"""

from __future__ import annotations

import json
import sys
from importlib.metadata import distributions
from pathlib import Path

from msgspec.structs import asdict, replace

from judge.data import GroupData, ProblemData
from judge.data.libraries import LIBRARIES, LibraryRow, LibraryTable, read_libraries, table_of
from judge.data.pins import write_rows
from judge.errors import UsageError
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.problem import Problem, Verdict
from judge.problem.model import GroupLimits
from judge.problem.solutions import Solution, SolutionKind, install_command, read_solutions, requirement
from judge.run.execute import judge_submission
from judge.run.result import Behaviour
from judge.run.settings import Settings
from judge.sandbox import Containment
from judge.sandbox.boundary import IMPORTING
from judge.sandbox.visible import package_folders
from judge.verify.model import Progress

_LIMITS = GroupLimits(cpu_seconds=120, wall_seconds=600, memory_mb=1024)  # some are large, some slow


def measure_libraries(
    problem: Problem, data: ProblemData, boxes: Containment, progress: Progress
) -> LibraryTable:
    """Judge the adapters whose packages are installed, and keep what comes of it. Raises ProblemError."""
    adapters, faults = read_solutions(problem, SolutionKind.LIBRARY)
    for fault in faults:
        raise fault
    rows, missing = read_libraries(problem), []
    for done, each in enumerate(adapters):
        progress("judging libraries", done, len(adapters))
        try:
            rows[each.path.stem] = measured(each, data, boxes)
        except UsageError as fault:
            missing.append(str(fault))
    rows = {each.path.stem: rows[each.path.stem] for each in adapters if each.path.stem in rows}
    write_rows(problem, LIBRARIES, {name: asdict(row) for name, row in rows.items()})
    return table_of(problem, rows, *missing)


def package_of(adapter: Solution) -> tuple[str, str]:
    """The package that it calls, and its version."""
    name, _, version = requirement(adapter.path).rpartition("==" if adapter.language is None else "@")
    return name, version


def installed_version(package: str, *, javascript: bool = False) -> str:
    """The version of a package among the judge's own and those of `$JUDGE_PACKAGES`; "" for none."""
    if javascript:
        places = [Path(folder, package, "package.json") for folder in package_folders("node_modules")]
        return next((str(json.loads(each.read_bytes())["version"]) for each in places if each.is_file()), "")
    found = distributions(name=package, path=[*sys.path, *package_folders()])
    return next((each.version for each in found), "")


def measured(adapter: Solution, data: ProblemData, boxes: Containment) -> LibraryRow:
    """What it answers to every case; nothing is timed.

    Raises UsageError where another version is installed or none, or its import ends.
    """
    library, version = package_of(adapter)
    found = installed_version(library, javascript=adapter.language is not None)
    if found != version:
        what = f"{library} {found} is installed, {adapter.file} calls {version}"
        command = install_command(requirement(adapter.path))
        raise UsageError(f"{what if found else f'{library} is not installed'}: {command}")
    problem = replace(data.problem, limits=_LIMITS)
    data = ProblemData(problem, data.groups, loaded=data.loaded)
    settings = Settings(box_factory=AnyBoxes(boxes, signature_of(problem)), measured=False)
    result, _, behaviour = judge_submission(data, adapter.source, adapter.path.name, settings)
    why = result.failure.message if result.failure else ""
    if why.endswith(IMPORTING):
        raise UsageError(
            f"{library} {version} is not measured: {why.removesuffix(IMPORTING)} ends the import"
        )
    groups = result.groups
    return LibraryRow(
        library,
        version,
        (sum(each.verdict is Verdict.AC for each in groups), len(groups)),
        (sum(each.passed for each in groups), sum(each.cases for each in groups)),
        _smallest(data.groups, behaviour) or why,
    )


def _smallest(groups: tuple[GroupData, ...], behaviour: Behaviour) -> str:
    """The failing case that takes the fewest characters, as `judge try` reads it, with its group."""
    found = [
        f"{', '.join(map(repr, each.cases[place]))} ({each.group.name})"
        for each in groups
        for place in (behaviour[each.group.name].wrong if each.group.name in behaviour else ())
    ]
    return min(found, key=len, default="")
