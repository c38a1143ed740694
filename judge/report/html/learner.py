"""The page that a person shows to others: what they have solved, which skills that shows, what went wrong.

Above everything stands the one chart: katas solved and skills shown, by day.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import date, datetime

from msgspec import Struct
from msgspec.structs import replace

from judge.drawing.chart import Axis, Chart, Series, chart_svg
from judge.drawing.shapes import Role
from judge.errors import StoreError
from judge.practice.events import Run
from judge.practice.progress import SkillProgress, State
from judge.problem import Problem, Verdict
from judge.report.html import day, page
from judge.report.html.case import Case, Cases
from judge.report.words import counted

MARK = "circle-line-judge report"  # in the head of every such page, also of older ones
_MOST_RUNS = 300  # of one kata in its table
_FIRST_RUNS = 8  # that are in sight; the earlier ones are folded away
_MOST_CASES = 12  # of one kata
_LONGEST_SOURCE = 12_000  # characters


class Failed(Struct, frozen=True):
    """The latest of the `times` runs with one mistake; `overcome` is when the kata was solved after it."""

    case: Case
    when: datetime
    times: int
    overcome: datetime | None


class Kata(Struct, frozen=True):
    """A kata with runs, newest first: `left_out` runs are not among them. `levels` are those passed."""

    anchor: str
    id: str
    title: str
    summary: str
    solved: datetime | None
    best: int
    levels: tuple[str, ...]
    ratio: float | None  # least time of an accepted run, as a multiple of the reference's
    runs: tuple[Run, ...]
    left_out: int
    failed: tuple[Failed, ...]
    source: str


def learner_page(
    runs: Sequence[Run],
    problems: Sequence[Problem],
    skills: Sequence[SkillProgress],
    sources: Mapping[str, bytes],
    *,
    person: str,
    generated: datetime,
) -> bytes:
    """The page of at least one run.

    Args:
        runs: those that count, of all katas, oldest first. Those of a kata that is gone are shown too.
        problems: all katas, in the order of the page.
        skills: how they stand after these runs; without any there is no list of skills.
        sources: the last accepted source of a kata, by its id.
        person: whose page it is, for its heading; may be empty.
        generated: when the page is made; its zone is that of all dates.
    """
    zone = generated.tzinfo
    runs = [replace(run, when=run.when.astimezone(zone)) for run in runs]
    own: dict[str, list[Run]] = {problem.id: [] for problem in problems}
    for run in runs:
        own.setdefault(run.problem, []).append(run)
    cases = Cases({problem.id: problem for problem in problems})
    katas = [
        _kata(f"kata-{at}", tried, cases, sources.get(name, b""))
        for at, (name, tried) in enumerate(own.items(), 1)
        if tried
    ]
    solved = [kata.solved for kata in katas if kata.solved]
    shown = [skill for skill in skills if skill.state is State.SHOWN]
    failed = [each for kata in katas for each in kata.failed if each.case.advice]
    days = len({run.when.date() for run in runs})
    tiles = [(f"{len(solved)} of {len(own)}", "katas solved")]
    if skills:
        tiles.append((f"{len(shown)} of {len(skills)}", "skills shown"))
    tiles.append((f"{len(runs):,}", f"{'run' if len(runs) == 1 else 'runs'} on {counted(days, 'day')}"))
    if failed:
        overcome = sum(each.overcome is not None for each in failed)
        tiles.append((f"{overcome} of {len(failed)}", "mistakes overcome"))
    moments = [skill.since.astimezone(zone) for skill in shown if skill.since]
    chart = _chart([run.when for run in runs], solved, moments)
    return page(
        "learner.html.j2",
        MARK,
        title=f"Progress: {person}" if person else "Progress",
        person=person,
        generated=generated,
        first=runs[0].when,
        last=runs[-1].when,
        tiles=tiles,
        chart=chart_svg(chart) if chart else "",
        katas=katas,
        skills=skills,
        first_runs=_FIRST_RUNS,
        drawn=any(each.case.drawings for kata in katas for each in kata.failed),
        verdicts=[each for each in Verdict if any(run.verdict is each for run in runs)],
    )


def _chart(runs: Sequence[datetime], solved: Sequence[datetime], skills: Sequence[datetime]) -> Chart | None:
    """Katas solved and skills shown by day; None where nothing is, or all is of one day."""
    days = [when.date().toordinal() for when in runs]
    first, last = min(days), max(days)
    if first == last or not solved:
        return None

    def series(name: str, moments: Sequence[datetime], role: Role) -> Series:
        made = Counter(when.date().toordinal() for when in moments)
        points, total = [(float(first - 1), 0.0)], 0
        for at in sorted({*made, last}):
            total += made[at]
            points.append((float(at), float(total)))
        return Series(name, tuple(points), role)

    both = [series("skills shown", skills, Role.LINE)] if skills else []
    both.insert(0, series("katas solved", solved, Role.WANTED))
    same = runs[0].year == runs[-1].year

    def shown(at: float) -> str:
        text = day(date.fromordinal(round(at)))
        return text.rpartition(" ")[0] if same else text

    about = f"{counted(len(solved), 'kata')} solved and {counted(len(skills), 'skill')} shown."
    title = "Katas solved and skills shown"
    return Chart(title, tuple(both), Axis("time", shown), Axis("katas and skills"), about)


def _kata(anchor: str, runs: Sequence[Run], cases: Cases, source: bytes) -> Kata:
    name = runs[0].problem
    problem = cases.problems.get(name)
    passed = [set(run.passed) for run in runs]
    levels = problem.levels if problem else ()
    groups = {level: {group.name for group in problem.of_level(level)} for level in levels} if problem else {}
    text = source.decode("utf-8", "backslashreplace")
    if len(text) > _LONGEST_SOURCE:
        text = text[:_LONGEST_SOURCE] + "\n… (the rest is left out)"
    return Kata(
        anchor=anchor,
        id=name,
        title=problem.title if problem else name,
        summary=problem.summary if problem else "This kata is not here any more.",
        solved=next((run.when for run in runs if run.solved), None),
        best=max(run.score for run in runs),
        levels=tuple(level.value for level in levels if any(groups[level] <= each for each in passed)),
        ratio=min((run.ratio for run in runs if run.solved and run.ratio is not None), default=None),
        runs=tuple(runs[: -_MOST_RUNS - 1 : -1]),
        left_out=max(0, len(runs) - _MOST_RUNS),
        failed=tuple(_failed(anchor, runs, cases)),
        source=text,
    )


def _failed(anchor: str, runs: Sequence[Run], cases: Cases) -> Iterator[Failed]:
    """The latest run of every mistake, or of every verdict and first group where none is named."""
    kinds: dict[tuple[str, ...], list[Run]] = {}
    for run in reversed(runs):
        if run.verdict is not Verdict.AC:
            kind = (run.mistake,) if run.mistake else ("", run.verdict.value, *run.failed[:1])
            kinds.setdefault(kind, []).append(run)
    for at, same in enumerate(list(kinds.values())[:_MOST_CASES], 1):
        run = same[0]
        try:
            result = run.result
        except StoreError:  # the row is damaged: its columns are told all the same
            result = None
        case = cases.tell(run.problem, run.verdict, run.mistake or "", result, f"{anchor}-case-{at}")
        overcome = next((each.when for each in runs if each.id > run.id and each.solved), None)
        yield Failed(case, run.when, len(same), overcome)
