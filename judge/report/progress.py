"""What a person has learned and what is due, on a screen: sets, skills, questions, katas to repeat."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from rich.console import Group, RenderableType
from rich.text import Text

from judge.errors import JudgeError, StoreError
from judge.practice.events import Rating, Run
from judge.practice.progress import ChecklistQuestion, Evidence, EvidenceKind, SkillProgress, State
from judge.practice.review import Due, Review
from judge.practice.stub import usual_name
from judge.problem.find import find_problem
from judge.problem.model import FULL_SCORE, Verdict
from judge.report import published_progress as published
from judge.report.parts import (
    Cell,
    bad,
    bar,
    blocks,
    commands,
    facts,
    faint,
    good,
    head,
    heading,
    indented,
    joined,
    solved_bar,
    strong,
    table,
    text,
    under,
    verdict_style,
    warning,
)
from judge.report.published_result import RunReport
from judge.report.result import run_report
from judge.report.screen import Screen
from judge.report.words import counted, day, due_words, moment, shown_name, times

_MARKS = {State.OPEN: faint(""), State.SHOWN: good("✓"), State.LOST: bad("lost")}
_RATED = {Rating.AGAIN: (bad, "not solved"), Rating.HARD: (warning, "solved, but not at once")}
_RUNS = ("run", "when", "kata", "file", "result", "mistake or failed group")
_NAMED = 12  # skills that are named in a row
_NARROW = 64  # columns that the table of sets needs
_LISTED = 3  # katas that are listed under Now and Again


def progress_page(found: published.ProgressPage, screen: Screen) -> RenderableType:
    """How many katas are solved, a bar for each set or the skills of one, what to do now, what was made."""
    (told,) = found.published
    whole, said = told.set, [*_now(found), *_made(told)]
    solved = solved_bar(len(whole.solved), len(whole.katas), whole.stars, screen.width)
    if not told.sets:
        below = commands([(f"judge list {whole.name}", "its katas")])
        return blocks(Group(strong(whole.title), solved), indented(facts([*_skills(told), *said])), below)
    narrow = screen.width is not None and screen.width < _NARROW
    sets = table((_set(each)[: 2 if narrow else None] for each in told.sets), right=[4], prose=None)
    below = commands(
        [("judge progress SET", "one set"), ("judge progress --due", "what to repeat, and when")]
    )
    return blocks(solved, indented(sets), indented(facts(said)), below)


def _set(part: published.SetShare) -> tuple[Cell, ...]:
    stars = [f"{'★' * at} {count}" for at, count in enumerate(part.stars, 1)] or ["", ""]
    skills = f"{part.shown} of {counted(part.skills, 'skill')}" if part.skills else ""
    done, katas = len(part.solved), len(part.katas)
    share = bar(done, katas, f"{done} of {katas}", 0)
    return (good if done == katas else text)(part.name), share, *stars, faint(skills)


def _skills(told: published.ProgressShown) -> Iterator[tuple[Cell, Cell]]:
    for state, label in ((State.SHOWN, good("shown")), (State.OPEN, faint("open"))):
        names = [each.name for each in told.skills if each.state is state]
        more = f"; {len(names) - _NAMED} more" if len(names) > _NAMED else ""
        if names:
            yield label, "; ".join(names[:_NAMED]) + more
    if told.set.solved:
        yield "solved", ", ".join(told.set.solved)


def _now(found: published.ProgressPage) -> Iterator[tuple[Cell, Cell]]:
    """What is unfinished, what comes again today, and the next kata."""
    now = [joined(each.problem, "  ", faint(_points(each.best))) for each in found.due.now[-_LISTED:]]
    due = [(each.name, f"last time {day(each.last)}; write it again from memory") for each in found.due.due]
    again = [joined(name, "  ", faint(said)) for name, said in due[:_LISTED]]
    yield from under(strong("now"), now)
    yield from under(strong("again"), again)
    if cards := found.due.cards_due:
        yield strong("cards"), f"{counted(cards, 'card')} due: judge quiz"
    if found.next:
        yield strong("next"), joined(f"judge start {found.next.id}", faint(f"  {found.next.title}"))


def _points(best: int) -> str:
    return f"{best} of {FULL_SCORE} points"


def _made(told: published.ProgressShown) -> Iterator[tuple[Cell, Cell]]:
    """The skills that were lost, the mistakes made, and how many questions are ticked."""
    if told.skills:
        yield "skills", _ticked(told.skills)
    for skill in (each for each in told.skills if each.state is State.LOST):
        failing = ", ".join(f"{need.problem} {group}" for need in skill.needs for group in need.failing)
        yield bad("lost"), f"{skill.name}: fails {failing}"
    if told.mistakes:
        often = ((name, f" {number} ×" if number > 1 else "") for name, number in told.mistakes.items())
        yield "mistakes", ", ".join(map("".join, often))
    if any(each.state is not State.OPEN for each in told.rows):
        yield "questions", _ticked(told.rows)


def _ticked(rows: Sequence[ChecklistQuestion | SkillProgress]) -> str:
    return f"{sum(each.state is State.SHOWN for each in rows)} of {len(rows)}"


def question_shown(found: published.QuestionShown, _screen: Screen) -> RenderableType:
    """One question with all that may tick it, and every command that practises it."""
    asked = found.question
    said = f"since {day(asked.since)}" if asked.since else "lost" if asked.state is State.LOST else "not yet"
    return blocks(
        table([(strong(asked.row), head(asked.ask, said))]),
        indented(table(map(_evidence, asked.by), "by", "", "since", "name")),
        facts(under("practise with", asked.drills)),
    )


def _evidence(each: Evidence) -> tuple[Cell, ...]:
    state = State.LOST if each.lost else State.SHOWN if each.since else State.OPEN
    kind = "mistake found" if each.kind is EvidenceKind.BROKEN else each.kind.value
    return faint(kind), _MARKS[state], faint(day(each.since)), each.name


def due(found: Due, _screen: Screen) -> RenderableType:
    """The katas that are unfinished, those that are due, the longest overdue first, and the others."""
    rows: list[tuple[Text, str, Cell]]
    rows = [(strong(it.problem), "now", f"{day(it.last)}: {_points(it.best)}") for it in found.now]
    rows += [(strong(it.name), due_words(it.due, found.time), _last(it)) for it in (*found.due, *found.later)]
    onward = [(f"judge start {it.name} --reset", "write it again, from memory") for it in found.due[:1]]
    return blocks(
        None if found.due or found.now else "Nothing is due today.",
        table(rows, "kata", "due", "last time") if rows else None,
        commands(onward or [("judge progress", "the next kata")]),
        f"Cards: {found.cards_due} due of {len(found.cards)} answered; judge quiz" if found.cards else None,
    )


def _last(each: Review) -> Text:
    """When it was, what happened, and after how many days it therefore comes again."""
    styled, how = _RATED.get(each.rating, (text, "solved at once"))
    return styled(f"{day(each.last)}: {how}, so again after {counted(each.days, 'day')}")


# -- runs ----------------------------------------------------------------------------------------------------


def run_list(found: published.RunList, _screen: Screen) -> RenderableType:
    """One row a run, the latest last; its file only where that is not called as its kata's usually is."""
    runs = found.runs
    if not runs:
        file = f"{found.problem} FILE" if found.problem else "FILE"
        return Group(text("No runs yet."), commands([(f"judge run {file}", "adds one")]))
    rows = [_run(run) for run in runs]
    more = faint(f"The last {counted(len(runs), 'run')}; --limit N shows more.") if found.more else None
    return blocks(table(rows, *_RUNS, right=[0]), more)


def _run(run: Run) -> tuple[Cell, ...]:
    name, when = shown_name(run.submission), faint(moment(run.when))
    file = "" if name == usual_name(run.problem) else name
    came_to = text(_result(run), verdict_style(run.verdict))
    return strong(str(run.id)), when, run.problem, file, came_to, _remark(run)


def _result(run: Run) -> str:
    """The verdict with the multiple of the reference's time, or with the points."""
    if run.whole:
        return f"{run.verdict.value} {times(run.ratio)} ×" if run.ratio is not None else run.verdict.value
    full = run.score == FULL_SCORE and run.verdict is not Verdict.AC  # those that fail are worth none
    return f"{run.verdict.value} {'extra fails' if full else run.score}"


def _remark(run: Run) -> str:
    """The level that it passed without the other, and its mistake, first failed group, or its only groups."""
    only = f"only {', '.join(run.passed)}" if run.verdict is Verdict.AC and not run.whole else ""
    said = [run.mistake or next(iter(run.failed), only)]
    with suppress(StoreError):  # of a damaged result the other columns are still true
        said = [*(f"{level} level passed" for level in (() if run.whole else run.levels)), *said]
    return ", ".join(filter(None, said))


def run_row(run: published.RunRow, screen: Screen) -> RenderableType:
    """When it was, what it came to, and how to get its source back."""
    result = run.result
    with suppress(JudgeError, ValueError):  # the kata is gone, or another one
        result = result.typed(find_problem(result.problem))
    return blocks(
        head(f"run {run.run}", faint(moment(run.time))),
        run_report(RunReport(result, whole=True, commands=False), screen),
        commands([(f"judge history {run.run} --restore", "write its source again")]),
    )


def restored(found: published.Restored, _screen: Screen) -> RenderableType:
    """Where a run's source is again, and where what was there is kept."""
    said = f"the source of run {found.run}, {moment(found.time)}, {found.problem}"
    kept = [faint(f"What was there is kept as {shown_name(found.kept_as)}.")] if found.kept_as else []
    kept = kept if found.written else [faint("It was there already.")]
    return heading(head(shown_name(found.file), said), *kept)
