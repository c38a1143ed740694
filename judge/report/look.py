"""Where you stand, the katas, one of them, what helps to solve it: its file, hints, solutions; the manual."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from rich.console import Group as Together
from rich.console import RenderableType
from rich.table import Column, Table
from rich.text import Text

from judge.languages import spelt
from judge.practice.events import Run
from judge.problem import Group, Problem, Tolerance
from judge.problem.model import FULL_SCORE
from judge.report import published_look as published
from judge.report.parts import (
    Cell,
    bad,
    blocks,
    commands,
    facts,
    faint,
    good,
    head,
    indented,
    joined,
    paragraph,
    prose,
    solved_bar,
    strong,
    table,
    text,
)
from judge.report.screen import Screen, is_terminal
from judge.report.words import counted, due_words, printable, seconds, shown_command, shown_name, times
from judge.run.result import Taken
from judge.values.answers import Words

_WHAT = (
    "You write one Python function. Each time you save the file, judge tests it on hundreds of cases. If it"
    " fails, you see the smallest case that fails, a picture, and the name of the mistake. Hints come one at"
    " a time, when you ask."
)
_LOOK = (
    ("Look", "judge list", "all katas, from first steps to professional"),
    ("Interview", "judge drill", "an evening: questions, a wrong program, a kata"),
    ("", "judge interview", "a mock interview of 30 minutes"),
    ("More", "judge help", "the manual"),
    ("", "judge --help", "all commands"),
)
_HITS = 8  # sections of the manual that are shown
BESIDE, _USUAL = 120, 80  # columns from which on two programs stand side by side; that a screen has


def home(found: published.Home, screen: Screen) -> RenderableType:
    """A page for a newcomer; for somebody who returns a bar, and what is now, again and next."""
    if found.begun:
        return _returning(found, screen)
    title = found.next.title if found.next else "There is no kata here"
    about = f"judge: practise {found.topic}. {counted(len(found.learner.problems), 'kata')}, offline."
    begin = _rows([("Begin", "judge start", f"{title}: your first kata, 5 minutes")])
    return blocks(about, begin, indented(paragraph(_WHAT)), _rows(_LOOK))


def _returning(found: published.Home, screen: Screen) -> RenderableType:
    mine, due, now, following = found.learner, found.due, found.now, found.next
    rows: list[tuple[str, str, str]] = []
    if now:
        folder, name = os.path.split(now.path)
        go_on = f"{shown_name(name)} is in another folder: {shown_command('cd', file=folder)}"
        if found.here:
            go_on = f"goes on with {shown_name(os.path.relpath(now.path))} in this folder"
        rows += [("Now", now.problem, _last(mine.own.get(now.problem, ())))]
        rows += [("", "judge start" if found.here else "", go_on)]
    if again := next((each for each in due.due if each.solved), None):
        said = f"solved {due_words(again.last, due.time)}; solve it once more from memory"
        rows += [("Again", again.name, said), ("", "", f"judge start {again.name} --reset")]
    if following:
        rows += [("Next", following.id, following.summary)]
        rows += [] if now and found.here else [("", "judge start", "creates its file")]
    elif not now:
        rows += [("Next", "", "All katas are solved.")]
    cards = f"{counted(due.cards_due, 'card')} due" if due.cards_due else "interview questions"
    more = commands([("judge progress", "what you can do so far"), ("judge quiz", cards)])
    done = solved_bar(len(mine.solved), len(mine.problems), mine.stars(mine.problems), screen.width)
    return blocks(done, _rows(rows), indented(more))


def _last(runs: Sequence[Run]) -> str:
    """What the last of the runs came to."""
    if not runs:
        return "not judged yet"
    likely = f", likely mistake: {runs[-1].mistake}" if runs[-1].mistake else ""
    return f"{runs[-1].score} of {FULL_SCORE} points{likely}"


def _rows(rows: Iterable[tuple[str, str, str]]) -> RenderableType:
    """Labels, names and what is said of them, in columns that are the same for all."""
    wide = ((strong if name else text, f"{name:<9}", f"{what:<15}", about) for name, what, about in rows)
    return indented(table((faint(name), style(what), about) for style, name, what, about in wide))


def kata_list(found: published.KataList, screen: Screen) -> RenderableType:
    """How many are solved, each set in a row, and the katas of one set; all of them where that is asked."""
    stars = Counter(row.stars for row in found.katas)
    done = solved_bar(_solved(found.katas), len(found.katas), (stars[1], stars[2]), screen.width)
    sets = {name: katas for name, katas in found.sets.items() if katas}
    if found.whole and not found.shown:
        every = (Together(strong(name), *_katas(found, name, None)) for name in sets)
        return blocks(done, *every)
    counting = {name: [row for row in rows if found.counts(row, name)] for name, rows in sets.items()}
    shares = ((name, f"{_solved(katas)} of {len(katas)}") for name, katas in counting.items())
    rows = [((strong if name == found.shown else text)(name), share) for name, share in shares]
    about = [table([(faint(found.about),)], prose=None)] if found.shown else []
    room = None if screen.rows is None or found.whole else screen.rows - len(rows) - 8
    return blocks(
        done,
        table(rows, right=[1], prose=None) if len(rows) > 1 else None,
        Together(*about, *_katas(found, found.shown, room)),
        commands([("judge list SET", "another set"), ("judge list --all", "all katas")]),
    )


def _solved(rows: Sequence[published.KataRow]) -> int:
    return sum(row.solved for row in rows)


def _katas(found: published.KataList, name: str, room: int | None) -> Iterator[RenderableType]:
    """The katas of that set with their marks, as many as there is room for."""
    there = found.wanted(found.sets.get(name, ()))
    kept = there if room is None or len(there) <= room else there[: max(room - 1, 1)]
    if not there:
        yield good("  All katas of this set are solved." if found.todo else "  There is no kata.")
    yield indented(table((_kata(found, name, row) for row in kept), prose=None))
    if len(kept) < len(there):
        yield faint(f"  … and {len(there) - len(kept)} more: add --all")


def _kata(found: published.KataList, name: str, row: published.KataRow) -> tuple[Cell, ...]:
    current, plain = row.problem == found.current, text if found.counts(row, name) else faint
    mark = "★" * row.stars or ("✓" if row.solved else "")
    return ">" if current else "", good(mark), (strong if current else plain)(row.problem), plain(row.title)


def kata_shown(found: published.KataShown, screen: Screen) -> RenderableType:
    """The statement and what is allowed; or the test groups."""
    problem, source, limits = found.problem, found.problem.source, found.problem.limits
    if found.groups:
        return blocks(*_levels(problem))
    from judge.report.picture import statement  # which no list needs

    answer = f"{problem.answer}, {_tolerance(_usual(problem), problem.answer.words)}"
    said = (
        ("tests", f"{_totals(problem.groups)}: judge show {problem.id} --groups"),
        ("answer", "" if problem.talks or problem.methods else answer),
        ("limits", f"{limits.cpu_seconds:g} s of CPU time, {limits.memory_mb:,.0f} MB for each group"),
        ("authors", ", ".join(source.authors)),
        ("license", source.license),
        ("origin", source.origin),
    )
    return blocks(statement(problem, screen), facts(each for each in said if each[1]))


def _levels(problem: Problem) -> Iterator[RenderableType]:
    """What the groups of a problem test, and the mistakes that they find."""
    top = [head(problem.id, problem.title)]
    if rule := problem.growth:
        faster = f"n^{rule.slope:g} faster than the reference, over {', '.join(rule.groups)}"
        top.append(text(f"CPU time may grow at most {faster}."))
    yield Together(*top)
    for level in problem.levels or (None,):
        own = [group for group in problem.groups if group.level is level]
        rows = [(strong(each.name), str(each.count), str(each.points), _about(problem, each)) for each in own]
        title = f"{level.value.capitalize()} level" if level else "Test groups"
        below = table(rows, "group", "cases", "points", "tests", right=[1, 2])
        if own:
            yield Together(head(title, _totals(own)), indented(below))


def _about(problem: Problem, group: Group) -> Text:
    """What one group tests and allows, and on a line of its own the mistakes it finds."""
    limits = [f"{group.limits.cpu_seconds:g} s"] if group.limits else []
    limits += [f"{group.time_limit:g} × the reference"] if group.time_limit is not None else []
    time = f" CPU time: at most {' and '.join(limits)}." if limits else ""
    usual = group.tolerance == _usual(problem)
    tolerance = "" if usual else f" Tolerance: {_tolerance(group.tolerance, problem.answer.words)}."
    said = text(f"{group.about}{time}{tolerance}")
    return Text("\n").join([said, bad(", ".join(group.kills))]) if group.kills else said


def _usual(problem: Problem) -> Tolerance:
    return Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]


def _totals(groups: Sequence[Group]) -> str:
    """`9 groups, 1,885 cases, 100 points`: what the groups hold together."""
    cases = sum(group.count for group in groups)
    points = sum(group.points for group in groups)
    return ", ".join((counted(len(groups), "group"), counted(cases, "case"), counted(points, "point")))


def _tolerance(value: Tolerance, words: Words) -> str:
    """A tolerance in words, such as `1e-9 relative + 4 ulp`; what it counts in has the problem's own name."""
    unit = words.unit or "the answer's unit"
    bounds = ((value.extent, f"of {unit}"), (value.relative, "relative"))
    wide = " or ".join(f"{_short(number)} {what}" for number, what in bounds if number)
    ulps = f"{_short(value.ulps)} ulp" if value.ulps else ""
    said = " + ".join(filter(None, (wide, ulps))) or "exact"
    return f"{said}; where the exact number is 0, {_short(value.zero)} of {unit}" if value.zero else said


def _short(value: Fraction) -> str:
    """The shortest of its exact forms: `4`, `1e-12`, `1/3`."""
    short = re.sub("e-0+", "e-", f"{float(value):g}")
    return short if Fraction(short) == value else str(value)


def begun(found: published.Begun, _screen: Screen) -> RenderableType:
    """One line: the file, and what to do with it."""
    file = shown_name(found.file)
    if not found.created:
        return joined(strong(f"{file} exists."), " Go on: judge run. Start over: add --reset")
    kept = f" The old text is in {shown_name(found.kept)}." if found.kept else ""
    what = spelt(found.entry, found.file) if found.entry else "the program"
    return joined(strong(f"Created {file}."), f"{kept} Write {what}, then: judge run")


def hint_shown(found: published.HintShown, screen: Screen) -> RenderableType:
    """The hint under its title; after the last one, what is left to do."""
    place = faint(f"{found.problem}, hint {found.step} of {found.steps}")
    onward = commands([(f"judge solution {found.problem} --give-up", "the solution")])
    last = ["That was the last hint.", onward] if found.step == found.steps else []
    return blocks(table([(strong(found.title), place)]), prose(found.text, screen), Together(*last))


def solution_shown(found: published.SolutionShown, screen: Screen) -> RenderableType:
    """Its idea, why it works, and the program, whose lines are never broken: they can be copied."""
    shown = found.shown
    fence = [] if is_terminal(screen.stream) else [Text(f"```{shown.code}"), Text("```")]
    return blocks(
        head(f"{found.problem}: {shown.idea.replace('-', ' ')}", shown.file),
        prose(shown.explanation, screen) if shown.explanation else None,
        Together(*fence[:1], *_source(shown.program), *fence[1:]),
        _timed(found) if shown.taken else _beside(found),
    )


def model(found: published.SolutionShown, yours: bytes, screen: Screen, *, whole: bool) -> RenderableType:
    """The model, why it works, and the person's own: beside it where there is room and not `whole`."""
    shown, width = found.shown, screen.width or _USUAL
    own = yours.decode("utf-8", "replace").strip("\n") if yours else ""
    programs = [(shown.idea.replace("-", " "), shown.program), *([("yours", own)] if own else [])]
    apart = width < BESIDE or whole or not own
    sides = [Together(strong(name), Text(), *_source(each, folded=apart)) for name, each in programs]
    why = prose(shown.explanation, screen) if shown.explanation and not whole else None
    if apart:
        return blocks(why, *sides)
    columns = (Column(width=width // 2 - 2, no_wrap=True, overflow="crop") for _ in sides)
    both = Table.grid(*columns, padding=(0, 2, 0, 0))
    both.add_row(*sides)
    return blocks(why, both)


def _source(program: str, *, folded: bool = False) -> list[Text]:
    rows = (printable(row.expandtabs(4)) for row in program.split("\n"))
    return [Text(row, no_wrap=not folded, overflow="fold" if folded else "ignore") for row in rows]


def _beside(found: published.SolutionShown) -> RenderableType:
    """The other approaches in its language by name, and the other languages."""
    command, shown = f"judge solution {found.problem}", found.shown
    own = [each for each in found.approaches if each.language == shown.language]
    others = [*dict.fromkeys(each.language for each in found.approaches if each not in own)]
    rows = [(strong(each.call), "the one above" if each == shown else each.about) for each in own]
    below = [(f"{command} {each.call}", "another approach") for each in own if each != shown][:1]
    below += [(f"{command} --language {each}", "one of them") for each in others[:1]]
    also = [text(f"Also in {', '.join(others)}.")] if others else []
    return blocks(
        table(rows, "approach", "idea") if len(own) > 1 else None,
        Together(*also, commands([*below, (f"{command} --times", "what each takes")])),
    )


def _timed(found: published.SolutionShown) -> RenderableType:
    """What each approach takes for one case, the person's own last."""
    rows = [(strong(each.call), each.language, *_taken(each.taken)) for each in found.approaches]
    if own := found.yours:
        which = faint(f"run {own.run}, {shown_name(own.file)}")
        rows.append((good("yours"), "", *_taken(own.taken)[:2], which))
    titles = ("approach", "language", "CPU, one case", f"× {found.approaches[0].call}", "")
    return table(rows, *titles, right=[2, 3])


def _taken(taken: Taken | None) -> tuple[str, str, Text]:
    """CPU seconds of a case, which are often few microseconds, the ratio, and why there are none."""
    if taken is None or taken.seconds is None:
        return "", "", faint(taken.why_not if taken else "")
    short = f"{1e6 * taken.seconds:.3g} µs" if taken.seconds < 1e-3 else seconds(taken.seconds)
    return short, times(taken.ratio) if taken.ratio is not None else "", Text()


def topics(told: published.Topics, _screen: Screen) -> RenderableType:
    """Every topic with its title, and how to read one."""
    rows = [(strong(each.topic), each.title) for each in told.published]
    below = [("judge help TOPIC", "read one"), ("judge help WORDS", "find the pages that mention them")]
    return blocks(table(rows), commands(below))


def mentions(told: published.Mentions, _screen: Screen) -> RenderableType:
    """The sections that have the words, each below the name of its page."""
    if not told.published:
        remedy = f"Did you mean judge help {told.near}?" if told.near else "judge help lists the topics."
        return text(f"No page mentions {told.words!r}. {remedy}")
    shown = told.published[:_HITS]
    hits = [Together(head(each.topic, each.section), indented(text(each.line))) for each in shown]
    left = len(told.published) - _HITS
    more = [faint(f"and {left} more sections")] if left > 0 else []
    return Together(text(f"Pages that mention {told.words!r}:"), *hits, *more)


def document(told: published.Document, screen: Screen) -> RenderableType:
    """A page, drawn for a person and as it is in a pipe; or a text, line by line."""
    if told.paged:
        return prose(told.text, screen)
    return Together(*(Text(row) for row in told.text.rstrip("\n").split("\n")))
