"""Hand-ins of different students to one problem that are one program but for names, spacing and comments.

Nothing but equality is told: no likeness, no share, no verdict. Short solutions of a kata are often alike, so
that programs of fewer than `LEAST` words are left out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import PurePath

from judge.batch.model import Handin
from judge.batch.normal import NormalForm, normal_form
from judge.cache import digest
from judge.errors import ProblemError
from judge.languages import SUFFIX
from judge.practice.stub import make_stub
from judge.problem import Problem
from judge.report.published_klass import Alike

# Of 339 functions in independent accepted programs equal pairs have at most 41 words, such as the dot product
# of two points. No two such programs are equal; a whole one of twice that is no accident any more.
LEAST = 80


def equal_files(
    handins: Iterable[Handin], problems: Mapping[str, Problem], least: int = LEAST
) -> list[Alike]:
    """The sets of equal files, by problem and then by the first student's name.

    `problems` are those handed in to, by id: the name of the entry function is nobody's own choice, and a
    stub is nobody's own work. Hand-ins that are not judged, or without a source, take no part.
    """
    entries = {name: problem.entry for name, problem in problems.items()}
    stubs = {name: _stub(problem) for name, problem in problems.items()}
    found: dict[tuple[str, str], list[tuple[Handin, int]]] = defaultdict(list)
    forms: dict[tuple[str, str, bytes], NormalForm] = {}
    for each in handins:
        if each.why or not each.source:
            continue
        text = each.problem, PurePath(each.file).suffix, each.source
        if text not in forms:
            forms[text] = normal_form(each.source, each.file, entries.get(each.problem, ""))
        form = forms[text]
        if form.words >= least and form.text != stubs.get(each.problem):
            same = digest(form.text.encode("utf-8", "surrogatepass"))
            found[each.problem, same].append((each, form.words))
    sets = [_told(each) for each in found.values() if _several(handin for handin, _ in each)]
    return sorted(sets, key=lambda each: (each.problem, each.students, each.files))


def _stub(problem: Problem) -> str:
    """The normal form of the file that the kata begins with, for Python."""
    try:
        return normal_form(make_stub(problem).encode(), f"stub{SUFFIX}", problem.entry).text
    except ProblemError:  # then nobody has been given one
        return ""


def _several(handins: Iterable[Handin]) -> bool:
    """Whether several students have submitted them, and not one file as a group."""
    groups: dict[str, set[str]] = {}
    for each in handins:
        groups.setdefault(each.file, set()).add(each.student)
    return len({*map(frozenset, groups.values())}) > 1


def _told(found: list[tuple[Handin, int]]) -> Alike:
    handins = sorted((handin for handin, _ in found), key=lambda each: (each.student, each.file))
    same_bytes = len({each.source for each in handins}) == 1
    return Alike(
        problem=handins[0].problem,
        what="identical files" if same_bytes else "identical after removing names, spacing and comments",
        students=tuple(dict.fromkeys(each.student for each in handins)),
        files=tuple(each.file for each in handins),
    )
