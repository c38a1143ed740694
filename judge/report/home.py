"""What `judge` alone shows: where to begin, or where to go on; and what `judge start` says in a pipe."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Group, RenderableType
from rich.text import Text

from judge.report.parts import FAINT, STRONG, Cell, bar, commands, indented, joined, table, text
from judge.report.published_start import Begun, Home, Now
from judge.report.screen import Screen
from judge.report.words import counted, shown_command, shown_name

_WHAT = (
    "You write one Python function. Each time you save the file, judge tests it on hundreds of cases. If it"
    " fails, you see the smallest case that fails, a picture, and the name of the mistake. Hints come one at"
    " a time, when you ask."
)
_LOOK = (
    ("Look", "judge list", "all katas, from first steps to professional"),
    ("Interview", "judge quiz", "short questions that need no code"),
    ("", "judge interview", "a mock interview of 30 minutes"),
    ("More", "judge help", "the manual"),
    ("", "judge --help", "all commands"),
)


def home(found: Home, screen: Screen) -> RenderableType:
    """A page for a newcomer; for somebody who returns a bar, and what is now, again and next."""
    return _returning(found, screen) if found.begun else _newcomer(found)


def _newcomer(found: Home) -> RenderableType:
    title = found.next.title if found.next else "There is no kata here"
    return Group(
        f"judge: practise circle and line geometry. {counted(found.katas, 'kata')}, offline.",
        Text(),
        _rows([("Begin", "judge start", f"{title}: your first kata, 5 minutes")]),
        Text(),
        indented(table(("",), [(_WHAT,)])),
        Text(),
        _rows(_LOOK),
    )


def _returning(found: Home, screen: Screen) -> RenderableType:
    said = f"{found.solved} of {counted(found.katas, 'kata')}"
    said += "".join(f"   {'★' * at} {count}" for at, count in enumerate(found.stars, 1) if count)
    rows: list[tuple[Cell, Cell, Cell]] = []
    if found.now:
        rows += [("Now", text(found.now.problem, STRONG), _last(found.now)), _go_on(found.now)]
    if found.again:
        days = found.again.days
        ago = "today" if not days else "yesterday" if days == 1 else f"{days} days ago"
        about = f"solved {ago}; solve it once more from memory"
        rows += [("Again", text(found.again.problem, STRONG), about)]
        rows += [("", "", f"judge start {found.again.problem} --reset")]
    if found.next:
        rows += [("Next", text(found.next.problem, STRONG), found.next.summary)]
        rows += [] if found.now and not found.now.folder else [("", "judge start", "creates its file")]
    elif not found.now:
        rows += [("Next", "", "All katas are solved.")]
    cards = found.cards_due
    due = f"{counted(cards, 'card')} {'is' if cards == 1 else 'are'} due" if cards else "interview questions"
    more = commands([("judge progress", "what you can do so far"), ("judge quiz", due)])
    return Group(
        bar(found.solved, found.katas, said, screen.width), Text(), _rows(rows), Text(), indented(more)
    )


def _last(now: Now) -> str:
    if now.points is None:
        return "not judged yet"
    return f"{now.points} of 100 points" + (f", likely mistake: {now.mistake}" if now.mistake else "")


def _go_on(now: Now) -> tuple[Cell, Cell, Cell]:
    file = shown_name(now.file)
    if not now.folder:
        return "", "judge start", f"goes on with {file} in this folder"
    return "", "", f"{file} is in another folder: {shown_command('cd', file=now.folder)}"


def begun(found: Begun, screen: Screen) -> RenderableType:  # noqa: ARG001 - a view takes one
    """One line: the file, and what to do with it."""
    file = shown_name(found.file)
    if not found.created:
        return joined(text(f"{file} exists.", STRONG), " Go on: judge run. Start over: add --reset")
    kept = f" The old text is in {shown_name(found.kept)}." if found.kept else ""
    return joined(text(f"Created {file}.", STRONG), f"{kept} Write {found.entry}, then: judge run")


def _rows(rows: Iterable[tuple[Cell, Cell, Cell]]) -> RenderableType:
    """Labels, names and what is said of them, in columns that are the same for all."""
    laid = []
    for label, name, about in rows:
        padded = text(label, FAINT).copy(), text(name).copy()
        for cell, width in zip(padded, (9, 15), strict=True):
            cell.pad_right(max(0, width - cell.cell_len))
        laid.append((*padded, about))
    return indented(table(("", "", ""), laid))
