"""Submissions of different students to one problem that are one program but for names, spacing and comments.

Nothing but equality is told: no likeness, no share, no verdict. Short solutions of a kata are often alike, so
that programs of fewer than `LEAST` words are left out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import PurePath

from judge.batch.model import Submission
from judge.batch.normalize import NormalForm, normal_form
from judge.errors import ProblemError
from judge.languages import SUFFIX
from judge.practice.stub import make_stub
from judge.problem import Problem
from judge.report.published_klass import Alike

# Of 339 functions in independent accepted programs equal pairs have at most 41 words, such as the dot product
# of two points. No two such programs are equal; a whole one of twice that is no accident any more.
LEAST = 80


def equal_files(
    submissions: Iterable[Submission], problems: Mapping[str, Problem], least: int = LEAST
) -> list[Alike]:
    """The sets of equal files, by problem and then by the first student's name.

    `problems` are those submitted to, by id: the name of the entry function is nobody's own choice, and a
    stub is nobody's own work. Submissions that are not judged, or without a source, take no part.
    """
    stubs = {name: _stub(problem) for name, problem in problems.items()}
    forms: dict[tuple[str, str, bytes], NormalForm] = {}
    found: dict[tuple[str, str], list[Submission]] = defaultdict(list)
    for each in submissions:
        if each.why or not each.source:
            continue
        problem, text = problems.get(each.problem), (each.problem, PurePath(each.file).suffix, each.source)
        if text not in forms:
            forms[text] = normal_form(each.source, each.file, problem.entry if problem else "")
        form = forms[text]
        if form.words >= least and form.text != stubs.get(each.problem):
            found[each.problem, form.text].append(each)
    sets = [_alike(group) for group in found.values() if _several(group)]
    return sorted(sets, key=lambda each: (each.problem, each.students, each.files))


def _stub(problem: Problem) -> str:
    """The normal form of the file that the kata begins with, for Python."""
    try:
        return normal_form(make_stub(problem).encode(), f"stub{SUFFIX}", problem.entry).text
    except ProblemError:  # then nobody has been given one
        return ""


def _several(group: Iterable[Submission]) -> bool:
    """Whether several students have submitted them, and not one file as a group."""
    members: dict[str, set[str]] = defaultdict(set)
    for each in group:
        members[each.file].add(each.student)
    return len({*map(frozenset, members.values())}) > 1


def _alike(group: list[Submission]) -> Alike:
    group = sorted(group, key=lambda each: (each.student, each.file))
    same_bytes = len({each.source for each in group}) == 1
    return Alike(
        problem=group[0].problem,
        what="identical files" if same_bytes else "identical after removing names, spacing and comments",
        students=tuple(dict.fromkeys(each.student for each in group)),
        files=tuple(each.file for each in group),
    )
