"""What a person has learned and what is due, on a screen: sets, skills, questions, katas to repeat."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from itertools import groupby

from rich.console import Group, RenderableType
from rich.text import Text

from judge.languages import file_name
from judge.practice.events import Rating
from judge.practice.progress import Covered, Evidence, Kind, Question, SkillProgress, State
from judge.practice.review import Review
from judge.problem.model import FULL_SCORE, KataLevel
from judge.report.history import day
from judge.report.parts import (
    BAD,
    FAINT,
    GOOD,
    STRONG,
    WARNING,
    Cell,
    bar,
    commands,
    facts,
    indented,
    joined,
    table,
    text,
)
from judge.report.published_progress import (
    DueShown,
    ProgressPage,
    ProgressShown,
    ProgressWritten,
    QuestionShown,
    SetShare,
    Unfinished,
)
from judge.report.screen import Screen
from judge.report.words import counted, shown_name

_STYLES = {State.OPEN: FAINT, State.SHOWN: GOOD, State.LOST: BAD}
_MARKS = {State.OPEN: "", State.SHOWN: "✓", State.LOST: "lost"}
_NAMED = 12  # skills that are named in a row
_NARROW = 64  # columns that the table of sets needs
_LISTED = 3  # katas that are listed under Now and Again


def progress_page(found: ProgressPage, screen: Screen) -> RenderableType:
    """How many katas are solved, a bar for each set or the skills of one, what to do now, what was made."""
    told = found.shown
    said = f"{len(told.solved)} of {counted(len(told.katas), 'kata')}"
    said += "".join(f"   {mark} {n}" for mark, n in (("★", told.one_star), ("★★", told.two_stars)) if n)
    parts: list[RenderableType] = [text(told.title, STRONG)] if not told.sets else []
    parts += [bar(len(told.solved), len(told.katas), said, screen.width), Text()]
    if found.whole:
        return Group(*parts, *_all(told))
    if told.sets:
        narrow = screen.width is not None and screen.width < _NARROW
        rows = [_set(each)[: 2 if narrow else None] for each in told.sets]
        parts += [indented(table([""] * len(rows[0]), rows, right=[4], prose=None)), Text()]
    parts.append(indented(facts([*([] if told.sets else _skills(told)), *_now(found), *_made(told)])))
    below = [("judge progress SET", "one set"), ("judge progress --due", "what to repeat, and when")]
    if not told.sets:
        below = [(f"judge progress {told.set} --all", "each skill, kata and question")]
    return Group(*parts, Text(), commands(below))


def _set(part: SetShare) -> tuple[Cell, ...]:
    style = GOOD if part.solved == part.katas else ""
    stars = [f"★ {part.one_star}", f"★★ {part.two_stars}"] if part.levelled else ["", ""]
    skills = f"{part.shown} of {counted(part.skills, 'skill')}" if part.skills else ""
    share = bar(part.solved, part.katas, f"{part.solved} of {part.katas}", 0)
    return (text(part.name, style), share, *stars, text(skills, FAINT))


def _skills(told: ProgressShown) -> Iterator[tuple[Cell, Cell]]:
    for state, label in ((State.SHOWN, "shown"), (State.OPEN, "open")):
        names = [each.name for each in told.skills if each.state is state]
        more = f"; {len(names) - _NAMED} more" if len(names) > _NAMED else ""
        if names:
            yield text(label, _STYLES[state]), "; ".join(names[:_NAMED]) + more
    if told.solved:
        yield "solved", ", ".join(told.solved)


def _now(found: ProgressPage) -> Iterator[tuple[Cell, Cell]]:
    """What is unfinished, what comes again today, and the next kata."""
    due = found.due
    for at, tried in enumerate(due.now[-_LISTED:]):
        yield "" if at else text("now", STRONG), joined(tried.problem, "  ", text(_points(tried), FAINT))
    for at, each in enumerate(due.due[:_LISTED]):
        ago = f"  last time {day(each.last)}; write it again from memory"
        yield "" if at else text("again", STRONG), joined(each.name, text(ago, FAINT))
    if cards := len(due.cards.due):
        yield text("cards", STRONG), f"{counted(cards, 'card')} due: judge quiz"
    if following := found.shown.next:
        skill = f"; new: {following.skill}" if following.skill else ""
        about = f"  {following.title}{skill}"
        yield text("next", STRONG), joined(f"judge start {following.problem}", text(about, FAINT))


def _points(tried: Unfinished) -> str:
    return f"{tried.best} of {FULL_SCORE} points"


def _made(told: ProgressShown) -> Iterator[tuple[Cell, Cell]]:
    """The skills that were lost, the mistakes made, how many questions are ticked and programs broken."""
    shown = sum(each.state is State.SHOWN for each in told.skills)
    if told.skills:
        yield "skills", f"{shown} of {len(told.skills)}"
    for skill in told.skills:
        if skill.state is State.LOST:
            yield text("lost", BAD), f"{skill.name}: fails {_failing(skill)}"
    if told.mistakes:
        yield "mistakes", counted_mistakes(told.mistakes)
    if told.rows and any(each.state is not State.OPEN for each in told.rows):
        first = told.rows[0].section
        own = [each for each in told.rows if each.section == first]
        more = f", {_ticked(told.rows)} in all" if len(own) < len(told.rows) else ""
        yield "questions", f"{first} {_ticked(own)}{more}"
    if told.hacks:
        shares = ", ".join(f"{each.problem} {len(each.broken)} of {each.programs}" for each in told.hacks)
        yield "broken", f"wrong programs of {shares}"


def _all(told: ProgressShown) -> Iterator[RenderableType]:
    """A row for each skill, for each kata that has levels, and for each question."""
    yield table(("skill", "", "since", "runs", "what it asks"), map(_skill, told.skills), right=[3])
    if told.levels:
        katas = dict.fromkeys(each.problem for each in told.levels)
        its = {(each.problem, each.level): each for each in told.levels}
        rows: list[list[Cell]] = [
            [kata, *(_level(its.get((kata, level))) for level in KataLevel)] for kata in katas
        ]
        yield Text()
        yield table(("kata", *(f"{level.value} level" for level in KataLevel)), rows, prose=None)
    for section, grouped in groupby(told.rows, lambda each: each.section):
        questions = list(grouped)
        yield Text()
        yield joined(text(section, STRONG), f"  {_ticked(questions)}")
        yield table(("id", "", "practise with", "question"), map(_question, questions))


def _skill(skill: SkillProgress) -> tuple[Cell, ...]:
    some = skill.state is State.SHOWN and skill.met < len(skill.needs)
    mark = f"✓ {skill.met} of {len(skill.needs)}" if some else _MARKS[skill.state]
    asks = f"Fails {_failing(skill)}." if skill.state is State.LOST else skill.about
    return (
        text(skill.name, FAINT if skill.state is State.OPEN else ""),
        text(mark, _STYLES[skill.state]),
        text(day(skill.since) if skill.since else "", FAINT),
        text(str(skill.attempts or ""), FAINT),
        text(asks, FAINT),
    )


def _failing(skill: SkillProgress) -> str:
    """The groups that were passed and no longer are, with their kata."""
    return ", ".join(f"{need.problem} {group}" for need in skill.needs if need.lost for group in need.failing)


def _level(each: Covered | None) -> Text:
    if each is None:
        return Text()
    if each.since is not None:
        return text(f"✓ {day(each.since)}", GOOD)
    return text(f"{each.best} of {counted(len(each.groups), 'group')}" if each.best else "", FAINT)


def _question(each: Question) -> tuple[Cell, ...]:
    mark = text(_MARKS[each.state], _STYLES[each.state])
    return text(each.row, STRONG), mark, text(next(iter(each.drills), ""), FAINT), each.ask


def _ticked(rows: Sequence[Question]) -> str:
    return f"{sum(each.state is State.SHOWN for each in rows)} of {len(rows)}"


def question(found: QuestionShown, _screen: Screen) -> RenderableType:
    """One question with all that may tick it, and every command that practises it."""
    asked = found.question
    said = "lost" if asked.state is State.LOST else "not yet"
    said = f"since {day(asked.since)}" if asked.since else said
    head = table(("", ""), [(text(asked.row, STRONG), joined(text(asked.ask, STRONG), f"  {said}"))])
    rows = table(("by", "", "since", "name"), map(_evidence, asked.by))
    labels = ("practise with", *[""] * len(asked.drills))
    below = facts([*zip(labels, asked.drills, strict=False)])
    return Group(head, Text(), indented(rows), Text(), below)


def _evidence(each: Evidence) -> tuple[Cell, ...]:
    state = State.LOST if each.lost else State.SHOWN if each.since else State.OPEN
    kind = "mistake found" if each.kind is Kind.BROKEN else each.kind.value
    since = day(each.since) if each.since else ""
    return text(kind, FAINT), text(_MARKS[state], _STYLES[state]), text(since, FAINT), each.name


def due(found: DueShown, _screen: Screen) -> RenderableType:
    """The katas that are unfinished, those that are due, the longest overdue first, and the others."""
    parts: list[RenderableType] = []
    if found.now:
        rows = [
            (text(each.problem, STRONG), _points(each), f"last run {day(each.last)}" if each.last else "")
            for each in found.now
        ]
        parts += [text("Now: not solved yet", STRONG), indented(table(("", "", ""), rows)), Text()]
    if found.due:
        first = found.due[0].name
        fresh = file_name(f"{first.replace('-', '_')}_{found.time:%m%d}")
        parts += [
            text(f"Due today: {counted(len(found.due), 'kata')}", STRONG),
            _reviews(found.due, found.time),
        ]
        parts += [commands([(f"judge start {first} {fresh}", "write it again, from an empty file")]), Text()]
    elif found.later:
        parts.append(joined(text("Nothing is due today.", GOOD), " Next:"))
    elif not found.now:
        nothing = "Nothing is due: you have solved no kata yet."
        parts += [text(nothing), commands([("judge progress", "the next kata")]), Text()]
    if found.later:
        parts += [*([text("Later", STRONG)] if found.due else []), _reviews(found.later, found.time), Text()]
    cards = (*found.cards.due, *found.cards.later)
    if cards:
        coming = min(cards, key=lambda each: each.due)
        when = "judge quiz" if found.cards.due else f"the next one {due_words(coming.due, found.time)}"
        parts += [text(f"Cards: {len(found.cards.due)} due of {len(cards)} answered; {when}"), Text()]
    if found.elsewhere:
        parts += [text(f"Not found from here: {', '.join(found.elsewhere)}; see --problems.", FAINT), Text()]
    return Group(*parts[:-1])


def _reviews(rows: Sequence[Review], now: datetime) -> RenderableType:
    return indented(
        table(
            ("kata", "due", "last time"),
            [
                (
                    text(each.name, STRONG),
                    due_words(each.due, now),
                    text(
                        f"{day(each.last)}: {_why(each)}",
                        {Rating.AGAIN: BAD, Rating.HARD: WARNING}.get(each.rating, ""),
                    ),
                )
                for each in rows
            ],
        )
    )


def due_words(due: datetime, now: datetime) -> str:
    """When it is due, in days from now: `in 3 days`, `today`, `1 day ago`."""
    days = (due.astimezone(now.tzinfo).date() - now.date()).days
    if days < 0:
        return f"{counted(-days, 'day')} ago"
    return "today" if days == 0 else f"in {counted(days, 'day')}"


def _why(each: Review) -> str:
    """What happened, and after how many days it therefore comes again."""
    if each.rating is Rating.AGAIN:
        how = "not solved"
    elif each.rating is Rating.HARD:
        how = "solved, but not at once"
    else:
        row = {1: "", 2: " twice in a row"}.get(each.in_a_row, f" {each.in_a_row} times in a row")
        how = f"solved at once{row}"
    return f"{how}, so again after {counted(each.days, 'day')}"


def counted_mistakes(mistakes: Mapping[str, int]) -> str:
    """`absolute-epsilon 3 ×, no-clamp`, in their order."""
    return ", ".join(name if number == 1 else f"{name} {number} ×" for name, number in mistakes.items())


def page_written(found: ProgressWritten, _screen: Screen) -> RenderableType:
    """Where the page is."""
    return joined(f"Wrote {shown_name(found.out)}", text(f"  {counted(found.runs, 'run')}", FAINT))
