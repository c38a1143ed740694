"""A problem's test groups as the files of a package: an input, an answer and what is accepted, for each."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from typing import Any

from msgspec import Struct

from judge.data.load import GroupData, ProblemData
from judge.packs.export.forms import accepted_form
from judge.problem.model import EXAMPLES
from judge.run.program import render_group
from judge.values import show


class Test(Struct, frozen=True):
    """One test group as a package has it.

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
        """The SHA-256 of the input, in hex."""
        return hashlib.sha256(self.input).hexdigest()


def tests_in(data: ProblemData) -> Iterator[Test]:
    """The groups in the order in which they are judged: the examples first. Raises NoForm, ProblemError."""
    groups = sorted(data.groups, key=lambda each: each.group.name != EXAMPLES)
    answer = data.problem.answer
    for place, group in enumerate(groups, 1):
        is_sample = group.group.name == EXAMPLES
        yield Test(
            group,
            "sample" if is_sample else "secret",
            f"{place:02d}-{group.group.name}",
            render_group(data.problem, group.cases),
            "".join(f"{show.line(answer, target)}\n" for target in group.targets).encode(),
            [accepted_form(answer, *data.exact(case, group.group)) for case in group.cases],
        )
