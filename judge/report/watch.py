"""What `judge start` shows on a terminal: the kata that was started, a result, and the keys below them."""

from __future__ import annotations

from rich.console import Group
from rich.text import Text

from judge.practice.syllabus import PracticeSet
from judge.problem import Problem
from judge.report.parts import FAINT, STRONG, WARNING, bar, text
from judge.report.screen import Screen, drawn
from judge.report.statement import prose
from judge.report.words import counted, shown_name

_KEYS = {
    "n": "next",
    "h": "hint",
    "s": "statement",
    "l": "list",
    "p": "picture",
    "e": "browser",
    "x": "start over",
    "q": "quit",
}
_OF_A_CASE = "pe"  # keys that need a case that failed


def place_text(
    problem: Problem, found: PracticeSet[Problem] | None, solved: int, katas: int, screen: Screen
) -> Group:
    """The kata's title, where it stands in its set, and how many are solved."""
    said = ""
    if found:
        at = [each.id for each in found.problems].index(problem.id) + 1
        said = f"{found.title.lower()}, kata {at} of {len(found.problems)}"
    head = text(f"{problem.id}  {problem.title}", STRONG)
    room = (screen.width or 80) - head.cell_len - len(said)
    rows = [Text.assemble(head, " " * room, (said, FAINT))] if room > 1 else [head, text(said, FAINT)]
    return Group(*rows, bar(solved, katas, f"{solved} of {counted(katas, 'kata')}", screen.width))


def begun_text(place: Group, problem: Problem, file: str, screen: Screen, rows: int) -> str:
    """The kata before its file is written, in so many rows: the task as far as there is room."""
    task = drawn(prose(_task(problem.statement), screen), screen).splitlines()
    head = drawn(
        Group(place, Text(), text(f"  Created {shown_name(file)}. Open it in your editor."), Text()), screen
    )
    end = drawn(Group(Text(), text("  Write the function, then save. I judge it on every save.")), screen)
    room = max(rows - head.count("\n") - end.count("\n"), 2)
    if len(task) > room:
        task = [*task[: room - 1], drawn(text("  … press s for the rest", FAINT), screen).rstrip("\n")]
    return head + "".join(f"{row}\n" for row in task) + end


def _task(statement: str) -> str:
    """A statement without its title, and without what follows the task."""
    return statement.partition("\n")[2].partition("\n## ")[0].strip() + "\n"


def note_text(said: str, screen: Screen, style: str = WARNING) -> str:
    """A sentence of the judge's own."""
    return drawn(text(said, style), screen)


def waiting_text(file: str, seconds: float, screen: Screen) -> str:
    """What is being judged, and for how long, on one line without its end."""
    width = (screen.width or 80) - 1
    said = f"judging {shown_name(file)}  {seconds:.1f} s"
    return drawn(text(said[-width:], FAINT), screen).rstrip("\n")


def keys_text(screen: Screen, *, failed: bool) -> str:
    """The keys on one line, without its end: what they do where there is room for it."""
    width = screen.width or 80
    shown = {key: about for key, about in _KEYS.items() if failed or key not in _OF_A_CASE}
    short = {key: about.split()[0] for key, about in shown.items()}
    for keys, gap in ((shown, "   "), (shown, "  "), (short, " "), (dict.fromkeys(shown, ""), " ")):
        parts = [Text.assemble((key, STRONG), f" {about}" if about else "") for key, about in keys.items()]
        line = Text(gap).join(parts)
        if line.cell_len < width:
            break
    return drawn(line, screen).rstrip("\n")
