"""From the rows of a class to what it is shown: whose row counts, which mistakes, who is stuck."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import PurePath
from types import MappingProxyType
from typing import Any

from msgspec.structs import replace

from judge.batch.model import KeptRow, Submission, text_of
from judge.batch.platforms import own_name
from judge.problem.model import Verdict
from judge.report.published_klass import Alike, Cohort, Grade, Machine, ProblemView, Student

_Pair = tuple[str, str]  # a student, and a problem or a file


def cohort_of(
    students: Sequence[Student],
    problems: Sequence[str],
    rows: Sequence[KeptRow],
    *,
    history: Iterable[KeptRow] = (),
    left: Sequence[Submission] = (),
    unread: Sequence[Submission] = (),
    equal_files: tuple[Alike, ...] = (),
    late: Mapping[_Pair, int | None] = MappingProxyType({}),
    **shown: Any,
) -> Cohort:
    """The class as it stands: the students and problems of the table, in its order, and the present rows.

    `history` are rows of texts that were submitted before and have been replaced since; they tell who is
    stuck and nothing else. `late` are days, by student and file, None where a platform says so alone. `left`
    are files without a row, `unread` what else of theirs is not judged; `shown` are the fields of the cohort
    that come from elsewhere.
    """
    counts = counting(rows)
    files = Counter((row.student, row.problem) for row in rows)
    marks: dict[str, dict[str, Grade]] = {}
    for (student, problem), row in counts.items():
        marks.setdefault(student, {})[problem] = _mark(row, files[student, problem], late)
    order = [each.id for each in students]
    own = {each: [counts[who, each] for who in order if (who, each) in counts] for each in problems}
    told, waiting = defaultdict[str, list[str]](list), defaultdict[str, list[str]](list)
    unjudged = [row for row in rows if row.result.verdict is Verdict.JE]
    reasons = [(each, each.why) for each in unread] + [(row, _message(row)) for row in unjudged]
    for each, why in reasons:
        told[each.student].append(f"{own_name(each.file)}: {why}")
    handed_in = {*counts, *((each.student, each.problem) for each in left)}
    for who, kata in sorted(handed_in - counts.keys()):
        waiting[who].append(kata)
    submitters = Counter(kata for _, kata in handed_in)
    seen = {*marks, *told}
    judged = Counter((row.done.machine, row.result.isolation) for row in rows if row.result.isolation)
    accepted = {who for (who, _), row in counts.items() if row.accepted}
    return Cohort(
        students=tuple(students),
        marks=marks,
        problems=tuple(_view(each, own[each], submitters[each]) for each in problems),
        stuck=tuple(_stuck(problems, [*history, *rows], order)),
        nothing_accepted=tuple(each for each in order if each in seen - accepted),
        nothing_handed_in=tuple(each for each in order if each not in seen | waiting.keys()),
        machines=tuple(Machine(*where, times) for where, times in sorted(judged.items())),
        unjudged=tuple((row.file, _message(row)) for row in unjudged),
        unread={who: tuple(reasons) for who, reasons in told.items()},
        waiting=waiting,
        equal_files=equal_files,
        left=len(left),
        **shown,
    )


def counting(rows: Iterable[KeptRow]) -> dict[_Pair, KeptRow]:
    """Of each student and problem the row that counts: of several files the best, and of equals the newest.

    The best is an accepted one, then the one of most points; one that could not be judged is the last.
    """
    found: dict[_Pair, KeptRow] = {}
    for row in rows:
        place = row.student, row.problem
        if place not in found or _worth(row) >= _worth(found[place]):
            found[place] = row
    return found


def samples(cohort: Cohort, rows: Iterable[KeptRow]) -> list[KeptRow]:
    """For each mistake of each problem, the row of the first student who made it."""
    by_file = {(row.problem, row.file): row for row in rows}
    mistakes = [each for view in cohort.problems for each in view.mistakes]
    return [by_file[each.problem, each.files[0]] for each in mistakes]


def _worth(row: KeptRow) -> tuple[bool, bool, int, float]:
    return row.accepted, row.result.verdict is not Verdict.JE, row.result.score, row.at


def _mark(row: KeptRow, files: int, late: Mapping[_Pair, int | None]) -> Grade:
    ratio, place = row.result.time.ratio, (row.student, row.file)
    return Grade(
        file=row.file,
        verdict=row.result.verdict,
        score=row.result.score,
        mistake=row.mistake,
        handins=files,
        copied=bool(row.copied),
        busy=bool(ratio and ratio.busy),
        late=late.get(place, 0) != 0,
        late_days=late.get(place),
    )


def _view(problem: str, rows: Sequence[KeptRow], handed_in: int) -> ProblemView:
    """The kata of these rows, of which one counts for each student; so many have submitted something."""
    made: dict[tuple[str, bool], list[KeptRow]] = defaultdict(list)
    for row in rows:
        if not row.accepted:
            made[row.mistake or _unnamed(row.result.verdict), bool(row.mistake)].append(row)
    failed = Counter(
        group.name for row in rows for group in row.result.groups if group.verdict is not Verdict.AC
    )
    return ProblemView(
        problem=problem,
        handed_in=handed_in,
        accepted=sum(row.accepted for row in rows),
        mistakes=tuple(_most_first(_alike(what, found, named) for (what, named), found in made.items())),
        groups=dict(failed.most_common()),
    )


def _unnamed(verdict: Verdict) -> str:
    return f"{verdict.meaning}, no mistake named" if verdict is Verdict.WA else verdict.meaning


def _stuck(problems: Sequence[str], rows: Iterable[KeptRow], order: Sequence[str]) -> Iterator[Alike]:
    """Whose last two files make the same mistake: by problem, and then that of the most students."""
    texts = {text_of(row): row for row in rows}.values()  # each by its newest row
    own: dict[_Pair, list[KeptRow]] = defaultdict(list)
    for row in sorted(texts, key=lambda row: (row.at, row.file)):
        own[row.student, row.problem].append(row)
    for problem in problems:
        held: dict[str, list[KeptRow]] = defaultdict(list)
        for student in order:
            rows = own[student, problem]
            made = {row.mistake for row in rows[-2:]}
            if len(rows) > 1 and len(made) == 1 and "" not in made and not any(row.accepted for row in rows):
                held[rows[-1].mistake].append(rows[-1])
        yield from _most_first(_alike(mistake, rows) for mistake, rows in held.items())


def _alike(what: str, rows: Sequence[KeptRow], named: bool = True) -> Alike:
    who, files = (row.student for row in rows), (row.file for row in rows)
    reasons = {(each.advice if (each := row.result.pitfall) else _message(row)) for row in rows}
    return Alike(rows[0].problem, what, tuple(who), tuple(files), named, len(reasons) == 1)


def _message(row: KeptRow) -> str:
    return row.result.failure.message if row.result.failure else ""


def _most_first(found: Iterable[Alike]) -> list[Alike]:
    return sorted(found, key=lambda each: (-len(each.students), not each.named, each.what))


def anonymous(cohort: Cohort) -> tuple[Cohort, dict[str, str]]:
    """The class with numbers in place of names, and what each file is called then."""
    numbers = {each.id: str(at) for at, each in enumerate(cohort.students, 1)}
    files = {
        mark.file: f"{numbers[who]}/{kata}{PurePath(mark.file).suffix}"
        for who, marks in cohort.marks.items()
        for kata, mark in marks.items()
    }

    def named(who: Sequence[str]) -> tuple[str, ...]:
        return tuple(numbers[each] for each in who)

    def alike(found: Sequence[Alike]) -> tuple[Alike, ...]:
        return tuple(replace(each, students=named(each.students), files=()) for each in found)

    people = [Student(numbers[each.id], known=each.known, note=each.note) for each in cohort.students]
    return replace(
        cohort,
        students=tuple(people),
        marks={
            numbers[who]: {kata: replace(mark, file=files[mark.file]) for kata, mark in marks.items()}
            for who, marks in cohort.marks.items()
        },
        problems=tuple(replace(each, mistakes=alike(each.mistakes)) for each in cohort.problems),
        stuck=alike(cohort.stuck),
        nothing_accepted=named(cohort.nothing_accepted),
        nothing_handed_in=named(cohort.nothing_handed_in),
        equal_files=alike(cohort.equal_files),
        unjudged=(),
        titles=(),
        waiting={numbers[who]: katas for who, katas in cohort.waiting.items()},
        unread={
            numbers[who]: tuple(re.sub(rf"^{re.escape(who)}\b", numbers[who], each) for each in told)
            for who, told in cohort.unread.items()
        },
    ), files
