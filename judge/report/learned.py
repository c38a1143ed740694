"""What a person has learned, for the screen: sets, skills, levels and questions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from judge.kata.checklist import Section
from judge.kata.progress import Covered, Evidence, Kind, Progress, RowProgress, SkillProgress, State
from judge.problem.model import KataLevel
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.levels import level_name
from judge.report.values import counted

_STYLES = {State.OPEN: Style.FAINT, State.SHOWN: Style.GOOD, State.LOST: Style.BAD}
_SAID = {State.OPEN: "", State.SHOWN: "✓", State.LOST: "lost"}
_LABELS = 13  # the column where what follows a label begins
Parts = Sequence[tuple[Section, Sequence[RowProgress]]]


def sets_lines(
    title: str, sets: Mapping[str, Collection[str]], progress: Progress, width: int | None
) -> Iterator[Line]:
    """A row a set, which are the ids of its katas by its name; below them what holds for all."""
    yield _heading(title, progress.skills)
    yield line()
    titles = ("katas", *(level.value for level in KataLevel), "skills")
    columns = (Column("set"), *(Column(each, right=True) for each in titles))
    rows = [_set(name, progress.within(own), own) for name, own in sets.items()]
    yield from Table(columns, rows).lines(width)
    yield line()
    yield from _notes(progress, progress.sections, width)
    yield from _labelled("more", "judge progress SET  what you can do; judge next  the next kata", width)


def set_lines(
    title: str, problems: Collection[str], progress: Progress, parts: Parts, width: int | None
) -> Iterator[Line]:
    """One set in short: its skills and katas by how they stand."""
    yield _heading(title, progress.skills)
    yield line()
    for state, label in ((State.SHOWN, "shown"), (State.OPEN, "open")):
        if names := [each.skill.name for each in progress.skills if each.state is state]:
            yield from _labelled(label, "; ".join(names), width, _STYLES[state])
    solved = [name for name in problems if _solved(progress, name)]
    text = f"{len(solved)} of {len(problems)} solved{': ' if solved else ''}{', '.join(solved)}"
    yield from _labelled("katas", text, width)
    begun = [level.problem for level in progress.levels if level.since and level.problem not in solved]
    if begun:
        yield from _labelled("", f"only the interview level: {', '.join(dict.fromkeys(begun))}", width)
    yield from _notes(progress, parts, width)
    yield from _labelled("more", "--all lists each skill, kata and question", width)


def all_lines(title: str, progress: Progress, parts: Parts, width: int | None) -> Iterator[Line]:
    """A row for each skill, for each kata that has levels, and for each question."""
    yield _heading(title, progress.skills)
    yield line()
    columns = (
        *(Column("skill"), Column(""), Column("since"), Column("runs", right=True)),
        Column("what it asks", flexible=True),
    )
    yield from Table(columns, [_skill(skill) for skill in progress.skills]).lines(width)
    if progress.levels:
        yield line()
        heads = (Column("kata"), *(Column(level_name(level)) for level in KataLevel))
        katas = dict.fromkeys(each.problem for each in progress.levels)
        own = [[each for each in progress.levels if each.problem == kata] for kata in katas]
        rows: list[list[Cell]] = [[Span(its[0].problem), *map(_level, its)] for its in own]
        yield from Table(heads, rows).lines(width)
    heads = (Column("id"), Column("", spare=True), Column("practise with"), Column("question", flexible=True))
    for section, questions in parts:
        yield line()
        yield from beside(Span(section.title, Style.STRONG), _ticked(questions), width)
        yield from Table(heads, [_question(each) for each in questions]).lines(width)


def question_lines(progress: RowProgress, width: int | None) -> Iterator[Line]:
    """One question with all that may tick it, and every command that practises it."""
    said = "lost" if progress.state is State.LOST else "not yet"
    said = f"since {day(progress.since)}" if progress.since else said
    yield from beside(Span(f"{progress.row.id}  {progress.row.ask}", Style.STRONG), said, width)
    yield line()
    columns = (Column("by"), Column(""), Column("since"), Column("name", flexible=True))
    yield from Table(columns, [_evidence(each) for each in progress.evidence]).lines(width)
    yield line()
    for place, command in enumerate(progress.drills):
        yield line(
            "  ", Span("" if place else "practise with", Style.FAINT), " " * (15 if place else 2), command
        )


def _heading(title: str, skills: Collection[SkillProgress]) -> Line:
    shown = sum(skill.state is State.SHOWN for skill in skills)
    return line(Span(title, Style.STRONG), f": {shown} of {counted(len(skills), 'skill')}")


def _labelled(label: str, text: str, width: int | None, style: Style = Style.FAINT) -> list[Line]:
    return hanging(Span(label, style), Span(text), width, indent=2, column=_LABELS)


def _notes(progress: Progress, parts: Parts, width: int | None) -> Iterator[Line]:
    """The skills that were lost, the mistakes made, and how many questions are ticked."""
    for skill in progress.skills:
        if skill.state is State.LOST:
            yield from _labelled("lost", f"{skill.skill.name}: fails {_failing(skill)}", width, Style.BAD)
    if made := sum(progress.mistakes.values(), Counter()):
        yield from _labelled("mistakes", counted_mistakes(made), width)
    if parts:
        section, rows = parts[0]
        more = f", {_ticked(row for _, own in parts for row in own)} in all" if len(parts) > 1 else ""
        yield from _labelled("questions", f"{section.title} {_ticked(rows)}{more}", width)


def _set(name: str, progress: Progress, problems: Collection[str]) -> list[Cell]:
    shares = [(sum(_solved(progress, each) for each in problems), len(problems))]
    for level in KataLevel:
        own = [each for each in progress.levels if each.level is level]
        shares.append((sum(each.since is not None for each in own), len(own)))
    shares.append((sum(each.state is State.SHOWN for each in progress.skills), len(progress.skills)))
    return [Span(name, Style.STRONG), *(_share(met, of) for met, of in shares)]


def _share(met: int, of: int) -> Span:
    style = Style.GOOD if met == of else Style.PLAIN if met else Style.FAINT
    return Span(f"{met} of {of}" if of else "", style)


def _solved(progress: Progress, problem: str) -> bool:
    standing = progress.standings.get(problem)
    return standing is not None and standing.passed is not None


def _skill(progress: SkillProgress) -> list[Cell]:
    some = progress.state is State.SHOWN and progress.met < len(progress.needs)
    share = f"✓ {progress.met} of {len(progress.needs)}"
    asks = f"Fails {_failing(progress)}." if progress.state is State.LOST else progress.skill.about
    return [
        Span(progress.skill.name, Style.FAINT if progress.state is State.OPEN else Style.PLAIN),
        Span(share if some else _SAID[progress.state], _STYLES[progress.state]),
        Span(day(progress.since) if progress.since else "", Style.FAINT),
        Span(str(progress.attempts or ""), Style.FAINT),
        Span(asks, Style.FAINT),
    ]


def _failing(progress: SkillProgress) -> str:
    """The groups that were passed and no longer are, with their problem."""
    return ", ".join(
        f"{need.problem} {group}" for need in progress.needs if need.lost for group in need.failing
    )


def _level(each: Covered) -> Span:
    if each.since is not None:
        return Span(f"✓ {day(each.since)}", Style.GOOD)
    return Span(f"{each.best} of {counted(len(each.groups), 'group')}" if each.best else "", Style.FAINT)


def _question(progress: RowProgress) -> list[Cell]:
    return [
        Span(progress.row.id, Style.STRONG),
        Span(_SAID[progress.state], _STYLES[progress.state]),
        Span(next(iter(progress.drills), ""), Style.FAINT),
        Span(progress.row.ask, Style.FAINT if progress.state is State.OPEN else Style.PLAIN),
    ]


def _evidence(each: Evidence) -> list[Cell]:
    state = State.LOST if each.lost else State.SHOWN if each.since else State.OPEN
    kind = "mistake found" if each.kind is Kind.BROKEN else each.kind.value
    since = day(each.since) if each.since else ""
    return [Span(kind, Style.FAINT), Span(_SAID[state], _STYLES[state]), Span(since, Style.FAINT), each.name]


def _ticked(rows: Iterable[RowProgress]) -> str:
    states = [row.state for row in rows]
    return f"{states.count(State.SHOWN)} of {len(states)}"


def counted_mistakes(mistakes: Mapping[str, int]) -> str:
    """`absolute-epsilon 3 ×, no-clamp`, the most frequent first."""
    found = Counter(mistakes).most_common()
    return ", ".join(name if number == 1 else f"{name} {number} ×" for name, number in found)
