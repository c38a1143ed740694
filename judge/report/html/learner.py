"""The page that a person shows to others: what they have solved, which skills that shows, what went wrong.

Above everything stands the one chart: katas solved and skills shown, by day.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from datetime import date, datetime
from typing import Any

from msgspec.structs import replace

from judge.drawing.chart import Axis, Chart, Series, chart_svg
from judge.drawing.shapes import Role
from judge.errors import StoreError
from judge.practice.events import Run
from judge.practice.progress import SkillProgress, State, levels_passed, tried
from judge.problem import Problem, Verdict
from judge.report.html import day, page
from judge.report.html.case import Case, Cases
from judge.report.words import counted

MARK = "circle-line-judge report"  # in the head of every such page, also of older ones
_MOST_RUNS = 300  # of one kata in its table
_MOST_CASES = 12  # of one kata
_Failed = tuple[Case, datetime, int, datetime | None]
_LONGEST_SOURCE = 12_000  # characters


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
    own = {problem.id: list[Run]() for problem in problems} | tried(runs)
    cases = Cases({problem.id: problem for problem in problems})
    katas = [
        _kata(f"kata-{at}", tried, cases, sources.get(name, b""))
        for at, (name, tried) in enumerate(own.items(), 1)
        if tried
    ]
    solved = [kata["solved"] for kata in katas if kata["solved"]]
    shown = [skill for skill in skills if skill.state is State.SHOWN]
    failed = [each for kata in katas for each in kata["failed"]]
    overcome = [when is not None for case, *_, when in failed if case.advice]
    days = counted(len({run.when.date() for run in runs}), "day")
    tiles = [(f"{len(solved)} of {len(own)}", "katas solved")]
    if skills:
        tiles.append((f"{len(shown)} of {len(skills)}", "skills shown"))
    tiles.append((f"{len(runs):,}", f"{'run' if len(runs) == 1 else 'runs'} on {days}"))
    if overcome:
        tiles.append((f"{sum(overcome)} of {len(overcome)}", "mistakes overcome"))
    moments = [skill.since.astimezone(zone) for skill in shown if skill.since]
    return page(
        "learner.html.j2",
        MARK,
        [case for case, *_ in failed],
        [run.verdict for run in runs],
        title=f"Progress: {person}" if person else "Progress",
        person=person,
        generated=generated,
        runs=runs,
        tiles=tiles,
        chart=_chart([run.when for run in runs], solved, moments),
        katas=katas,
        skills=skills,
    )


def _chart(runs: Sequence[datetime], solved: Sequence[datetime], skills: Sequence[datetime]) -> str:
    """Katas solved and skills shown by day, as an SVG; "" where nothing is, or all is of one day."""
    first, last = runs[0].date().toordinal(), runs[-1].date().toordinal()
    if first == last or not solved:
        return ""

    def series(name: str, moments: Sequence[datetime], role: Role) -> Series:
        days = sorted(when.date().toordinal() for when in moments)
        made = {first - 1: 0} | {at: number for number, at in enumerate(days, 1)}
        made.setdefault(last, len(days))
        return Series(name, tuple((float(at), float(number)) for at, number in made.items()), role)

    both = [series("katas solved", solved, Role.WANTED)]
    both += [series("skills shown", skills, Role.LINE)] if skills else []
    same = runs[0].year == runs[-1].year

    def shown(at: float) -> str:
        text = day(date.fromordinal(round(at)))
        return text.rpartition(" ")[0] if same else text

    about = f"{counted(len(solved), 'kata')} solved and {counted(len(skills), 'skill')} shown."
    title = "Katas solved and skills shown"
    return chart_svg(Chart(title, tuple(both), Axis("time", shown), Axis("katas and skills"), about))


def _kata(anchor: str, runs: Sequence[Run], cases: Cases, source: bytes) -> dict[str, Any]:
    """A kata with runs, newest first, of which `left_out` are not shown, and the levels that one passed."""
    problem = cases.problems.get(runs[0].problem)
    text = source.decode("utf-8", "backslashreplace")
    if len(text) > _LONGEST_SOURCE:
        text = text[:_LONGEST_SOURCE] + "\n… (the rest is left out)"
    return {
        "anchor": anchor,
        "id": runs[0].problem,
        "title": problem.title if problem else runs[0].problem,
        "summary": problem.summary if problem else "This kata is not here any more.",
        "solved": next((run.when for run in runs if run.solved), None),
        "best": max(run.score for run in runs),
        "levels": [each.value for each in levels_passed(problem, runs)] if problem else [],
        "ratio": min((run.ratio for run in runs if run.solved and run.ratio is not None), default=None),
        "runs": runs[: -_MOST_RUNS - 1 : -1],
        "left_out": max(0, len(runs) - _MOST_RUNS),
        "failed": [*_failed(anchor, runs, cases)],
        "source": text,
    }


def _failed(anchor: str, runs: Sequence[Run], cases: Cases) -> Iterator[_Failed]:
    """The latest run of every mistake, or of every verdict and first group where none is named.

    Beside its case: when it was, how many such runs there are, and when the kata was solved after it.
    """
    kinds: dict[tuple[str, ...], list[Run]] = {}
    for run in reversed(runs):
        if run.verdict is not Verdict.AC:
            kind = (run.mistake,) if run.mistake else ("", run.verdict.value, *run.failed[:1])
            kinds.setdefault(kind, []).append(run)
    for at, same in enumerate(list(kinds.values())[:_MOST_CASES], 1):
        run, result = same[0], None
        with suppress(StoreError):  # the row is damaged: its columns are told all the same
            result = run.result
        case = cases.tell(run.problem, run.verdict, run.mistake or "", result, f"{anchor}-case-{at}")
        overcome = next((each.when for each in runs if each.id > run.id and each.solved), None)
        yield case, run.when, len(same), overcome
