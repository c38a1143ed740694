"""From the runs of a history and the problems they are of to a page. Pure: nothing is judged or read here."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from datetime import datetime, tzinfo

from msgspec.structs import replace

from judge import __version__
from judge.kata.checklist import Section
from judge.kata.events import Answer, Hack, Run
from judge.kata.progress import RowProgress, SkillProgress, levels, mistake_names
from judge.problem import Problem, Tier, Verdict
from judge.report.page.cases import anchors, failing_cases, kind_of, left_out
from judge.report.page.checklist import ready_parts, skill_lines
from judge.report.page.growth import growth_plot
from judge.report.page.kills import kill_table
from judge.report.page.known import KnownProblem
from judge.report.page.parts import (
    GroupMark,
    LevelMark,
    OverviewLine,
    Page,
    ProblemPart,
    RunLine,
    SkillLine,
    Tile,
)
from judge.report.page.plot import ratio_plot
from judge.report.page.record import GroupRecord, read_record
from judge.report.values import counted, score_text, times

MOST_RUNS = 300  # of one problem in its tables
_FIRST_RUNS = 12  # that are in sight; the earlier ones are folded away
_LONGEST_SOURCE = 12_000  # characters

_TIERS = {tier.value: place for place, tier in enumerate(Tier)}


def compose_page(
    runs: Sequence[Run],
    known: Sequence[KnownProblem],
    sources: Mapping[str, bytes],
    skills: Sequence[SkillProgress] = (),
    *,
    ready: Sequence[tuple[Section, Sequence[RowProgress]]] = (),
    answers: Sequence[Answer] = (),
    hacks: Sequence[Hack] = (),
    generated: datetime,
    zone: tzinfo | None = None,
    person: str = "",
) -> Page:
    """The page of these runs, answers to cards and attempts at wrong programs, at least one of any of them.

    Args:
        runs: of all problems, oldest first; one that is not in `known` any more is shown by its runs alone.
        known: all problems, tried or not.
        sources: by problem, what the last run judged.
        skills: how they stand after these runs; without any there is no checklist.
        ready: the questions of the checklist by section, the first being what to be ready for.
        answers, hacks: what was done besides runs.
        generated: when the page is made.
        zone: the zone of all times shown; None for this machine's own.
        person: whose page it is, for its heading.
    """
    runs = [_in_zone(run, zone) for run in runs]
    checklist = tuple(skill_lines(skills, zone))
    by_id = {each.problem.id: each for each in known}
    tried: dict[str, list[Run]] = {}
    for run in runs:
        tried.setdefault(run.problem, []).append(run)
    order = {name: at for at, name in enumerate(by_id)}
    names = sorted(
        {*by_id, *tried}, key=lambda name: (_place(by_id.get(name)), order.get(name, len(order)), name)
    )
    parts = {
        name: _part(f"problem-{place}", tried[name], by_id.get(name), sources.get(name, b""))
        for place, name in enumerate(names, 1)
        if name in tried
    }
    moments = [
        *(run.when for run in runs),
        *(answer.when.astimezone(zone) for answer in answers),
        *(hack.when.astimezone(zone) for hack in hacks),
    ]
    return Page(
        title=f"Kata report: {person}" if person else "Kata report",
        person=person,
        generated=generated.astimezone(zone),
        version=__version__,
        first=min(moments),
        last=max(moments),
        tiles=tuple(_tiles(runs, answers, names, parts, checklist)),
        overview=tuple(_overview(name, by_id.get(name), tried.get(name), parts.get(name)) for name in names),
        untried=tuple(_untried(known, tried)),
        skills=checklist,
        ready=tuple(ready_parts(ready, zone)),
        problems=tuple(parts.values()),
        verdicts=tuple(verdict for verdict in Verdict if any(run.verdict is verdict for run in runs)),
    )


def _in_zone(run: Run, zone: tzinfo | None) -> Run:
    return replace(run, when=run.when.astimezone(zone))


def _place(known: KnownProblem | None) -> int:
    """Where a problem stands on the path; one that is gone, last."""
    return _TIERS[known.problem.tier.value] if known else len(_TIERS)


def _tiles(
    runs: Sequence[Run],
    answers: Sequence[Answer],
    names: Sequence[str],
    parts: Mapping[str, ProblemPart],
    skills: Sequence[SkillLine],
) -> Iterator[Tile]:
    solved = sum(part.solved is not None for part in parts.values())
    yield Tile(f"{solved} of {len(names)}", "problems solved")
    if skills:
        yield Tile(f"{sum(skill.ticked for skill in skills)} of {len(skills)}", "skills shown")
    if runs:
        days = len({run.when.date() for run in runs})
        yield Tile(f"{len(runs):,}", f"{'run' if len(runs) == 1 else 'runs'} on {counted(days, 'day')}")
    if answers:
        known = sum(answer.known for answer in answers)
        yield Tile(f"{known} of {len(answers)}", "answers to cards known")
    met = [case for part in parts.values() for case in part.cases if case.explained]
    if met:
        gone = sum(case.overcome is not None for case in met)
        yield Tile(f"{gone} of {len(met)}", "mistakes overcome")


def _untried(known: Sequence[KnownProblem], tried: Collection[str]) -> Iterator[tuple[str, tuple[str, ...]]]:
    """The problems without a run, in their order, by tier."""
    for tier in _TIERS:
        own = [each.problem.id for each in known if each.problem.tier.value == tier]
        if left := tuple(name for name in own if name not in tried):
            yield tier, left


def _overview(
    name: str, known: KnownProblem | None, runs: Sequence[Run] | None, part: ProblemPart | None
) -> OverviewLine:
    solved = [run.ratio for run in runs or () if run.solved and run.ratio is not None]
    return OverviewLine(
        id=name,
        title=known.problem.title if known else "",
        tier=known.problem.tier.value if known else "",
        part=part,
        ratio=f"{times(min(solved))} ×" if solved else "",
        last=runs[-1].when if runs else None,
    )


# -- one problem -------------------------------------------------------------------------------------------


def _part(anchor: str, runs: Sequence[Run], known: KnownProblem | None, source: bytes) -> ProblemPart:
    """`anchor` is its place in the page: a problem's own name may be any word, of the page's own too."""
    problem, name = known.problem if known else None, runs[0].problem
    places = anchors(anchor, runs)
    lines = [_run_line(run, places.get(kind_of(run), "")) for run in reversed(runs[-MOST_RUNS:])]
    counting = [run for run in runs if run.counts]
    made = Counter(mistake for run in counting for mistake in mistake_names(run))
    matrix = known.matrix if known else None
    solved = next((run.when for run in runs if run.solved), None)
    return ProblemPart(
        anchor=anchor,
        id=name,
        title=problem.title if problem else name,
        summary=problem.summary if problem else "This problem is not there any more.",
        tier=problem.tier.value if problem else "",
        solved=solved,
        best=score_text(max((run.score for run in counting), default=0), accepted=solved is not None),
        attempts=len(counting),
        levels=tuple(_levels(runs, problem)),
        groups=tuple(_groups(runs, problem)),
        runs=tuple(lines[:_FIRST_RUNS]),
        earlier=tuple(lines[_FIRST_RUNS:]),
        more=len(runs) - len(lines),
        plot=ratio_plot(anchor, counting, _time_limit(problem)),
        growth=growth_plot(anchor, counting),
        cases=tuple(failing_cases(problem, runs, places, known.advice if known else {})),
        cases_left_out=left_out(runs, places),
        kills=kill_table(matrix, made) if matrix else None,
        source=_source(source),
        source_name=runs[-1].submission,
        source_run=runs[-1].id,
    )


def _time_limit(problem: Problem | None) -> float | None:
    """The one limit that holds for the ratio of every run; None where groups have limits of their own."""
    if problem is None or problem.time is None or any(group.time_limit for group in problem.groups):
        return None
    return problem.time.limit


def _run_line(run: Run, case: str) -> RunLine:
    ratio = f"{times(run.ratio)} ×" if run.ratio is not None else ""
    shown = case if run.counts and run.verdict is not Verdict.AC else ""
    score = score_text(run.score, accepted=run.verdict is Verdict.AC)
    return RunLine(run.id, run.when, run.verdict, score, ratio, run.mistake or "", shown, run.submission)


def _levels(runs: Sequence[Run], problem: Problem | None) -> Iterator[LevelMark]:
    for each in levels(problem, runs) if problem else ():
        assert each.level is not None
        yield LevelMark(each.level.value, len(each.groups), each.best, each.since)


def _groups(runs: Sequence[Run], problem: Problem | None) -> Iterable[GroupMark]:
    """Every group as the latest run left it that ran it."""
    found: dict[str, GroupRecord] = {}
    names = [group.name for group in problem.groups] if problem else None
    for run in reversed(runs):
        if names is not None and all(name in found for name in names):
            break
        if not set(found).issuperset((*run.passed, *run.failed)):
            for group in read_record(run).groups:
                found.setdefault(group.name, group)
    groups = problem.groups if problem else ()
    about = {group.name: group.about for group in groups}
    level = {group.name: group.level.value for group in groups if group.level}
    for name in names if names is not None else found:
        if name not in found:
            yield GroupMark(name, about.get(name, ""), "open", "not run", level.get(name, ""))
            continue
        group = found[name]
        accepted = group.verdict == Verdict.AC.value
        detail = "" if accepted else f"{group.passed} of {group.cases}"
        state = "passed" if accepted else "failed"
        yield GroupMark(name, about.get(name, ""), state, detail, level.get(name, ""))


def _source(source: bytes) -> str:
    text = source.decode("utf-8", "backslashreplace")
    if len(text) <= _LONGEST_SOURCE:
        return text
    return text[:_LONGEST_SOURCE] + "\n… (the rest is left out)"
