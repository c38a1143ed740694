"""A problem's test groups as files: those of a package, or those for other tools."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from judge.data import GroupData, ProblemData
from judge.packs.schemas import accepted_form
from judge.problem.formats import input_of, output_of
from judge.problem.model import EXAMPLES
from judge.run.program import render_group
from judge.values import show
from judge.values.parameters import given as given_to_solve

SCHEMA = 1  # of a group's JSON
MOST_INPUT = 64  # of a test, in millions of bytes


class Test(Struct, frozen=True):
    """One test group as a package has it, or one of its cases where each is a run of its own.

    `stem` is the files' name without its ending, `accepted` what the output validator accepts for each case.
    """

    group: GroupData
    folder: str  # sample or secret
    stem: str
    input: bytes
    answer: bytes
    accepted: list[Any]

    @property
    def key(self) -> str:
        """By which a validator knows the input: its SHA-256."""
        return hashlib.sha256(self.input).hexdigest()


def tests_in(data: ProblemData, large: list[str]) -> Iterator[Test]:
    """The groups as they are judged, the examples first. Raises NotExportable, ProblemError.

    `large` is told of each that no package has room for.
    """
    groups = sorted(data.groups, key=lambda each: each.group.name != EXAMPLES)
    for place, whole in enumerate(groups, 1):
        name = whole.group.name
        for suffix, group in _parts(data, whole):
            stem, (given, answers) = f"{place:02d}-{name}{suffix}", _both(data, group)
            if len(given) > MOST_INPUT * 10**6:
                large.append(f"{stem}, {len(given) / 10**6:,.0f} MB")
                continue
            folder = "sample" if name == EXAMPLES else "secret"
            yield Test(group, folder, stem, given, answers, _accepted(data, group))


def _parts(data: ProblemData, whole: GroupData) -> Iterator[tuple[str, GroupData]]:
    """The group, or each of its cases where each is a run of its own; with what its name ends in."""
    if not data.problem.formatted:
        yield "", whole
        return
    width = max(2, len(str(len(whole.cases))))
    for at, (case, target) in enumerate(zip(whole.cases, whole.targets, strict=True), 1):
        yield f"-{at:0{width}d}", replace(whole, cases=[case], targets=[target])


def _accepted(data: ProblemData, group: GroupData) -> list[Any]:
    """What is accepted for each case; in a dialogue its arguments, as Python writes them."""
    problem = data.problem
    if problem.talks:
        return [repr(tuple(each)) for each in problem.calls(group.cases)]
    types = [each.type for each in problem.parameters]
    return [
        accepted_form(problem.answer, *data.exact(case, group.group), tuple(map(given_to_solve, types, case)))
        for case in group.cases
    ]


def _both(data: ProblemData, group: GroupData) -> tuple[bytes, bytes]:
    """What a program reads and what a right one prints."""
    problem, own = data.problem, data.module.format
    if own and not problem.talks:
        (case,), (target,) = group.cases, group.targets
        return input_of(problem, own, case).encode(), output_of(problem, own, target).encode()
    return render_group(problem, group.cases), b"" if problem.talks else _answers(data, group)


def group_files(data: ProblemData, group: GroupData) -> dict[str, bytes]:
    """The files of one group for other tools, by name, with a FORMAT those of each case.

    Raises ProblemError where the reference fails.
    """
    name, problem = group.group.name, data.problem
    files: dict[str, bytes] = {}
    for suffix, part in [("", group)] if problem.talks else _parts(data, group):
        given, answers = _both(data, part)
        answers = _answers(data, part) if problem.talks else answers
        files |= {f"{name}{suffix}.in": given, f"{name}{suffix}.ans": answers}
    return {**files, f"{name}.json": _document(data, group).encode()}


def _answers(data: ProblemData, group: GroupData) -> bytes:
    return "".join(f"{show.line(data.problem.answer, target)}\n" for target in group.targets).encode()


def _document(data: ProblemData, group: GroupData) -> str:
    """The group's object, a case on each line, with its exact answer."""
    problem = data.problem
    head = {
        "schema": SCHEMA,
        "problem": problem.id,
        "group": group.group.name,
        "seed": group.group.seed,
        "entry": problem.entry,
    }
    cases = [
        json.dumps(
            {
                "input": problem.named(case),
                "expected": show.exact_text(data.exact(case, group.group)[0]),
                "accepted": show.accepted(problem.answer, target),
            }
        )
        for case, target in zip(group.cases, group.targets, strict=True)
    ]
    return json.dumps(head)[:-1] + ', "cases": [\n' + ",\n".join(cases) + "\n]}\n"
