"""What helps to solve a kata: its file, hints, solutions."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from judge.languages import spelt
from judge.report.parts import blocks, commands, faint, good, head, joined, prose, strong, table, text
from judge.report.published_practise import Begun, HintShown, SolutionShown
from judge.report.screen import Screen, is_terminal
from judge.report.words import printable, seconds, shown_name, times
from judge.run.result import Taken

BESIDE, _USUAL = 120, 80  # columns from which on two programs stand side by side; that a screen has


def begun(found: Begun, _screen: Screen) -> RenderableType:
    """One line: the file, and what to do with it."""
    file = shown_name(found.file)
    if not found.created:
        return joined(strong(f"{file} exists."), " Go on: judge run. Start over: add --reset")
    kept = f" The old text is in {shown_name(found.kept)}." if found.kept else ""
    what = spelt(found.entry, found.file) if found.entry else "the program"
    return joined(strong(f"Created {file}."), f"{kept} Write {what}, then: judge run")


def hint_shown(found: HintShown, screen: Screen) -> RenderableType:
    """The hint under its title; after the last one, what is left to do."""
    place = faint(f"{found.problem}, hint {found.step} of {found.steps}")
    last: list[RenderableType] = []
    if found.step == found.steps:
        onward = commands([(f"judge solution {found.problem} --give-up", "the solution")])
        last = [text("That was the last hint."), onward]
    title = table([(strong(found.title), place)])
    return blocks(title, prose(found.text, screen), Group(*last))


def solution_shown(found: SolutionShown, screen: Screen) -> RenderableType:
    """Its idea, why it works, and the program, whose lines are never broken: they can be copied."""
    shown = found.shown
    fence = [] if is_terminal(screen.stream) else [Text(f"```{shown.code}"), Text("```")]
    return blocks(
        head(f"{found.problem}: {shown.idea.replace('-', ' ')}", shown.file),
        prose(shown.explanation, screen) if shown.explanation else None,
        Group(*fence[:1], *_source(shown.program), *fence[1:]),
        _timed(found) if shown.taken else _beside(found),
    )


def model(found: SolutionShown, yours: bytes, screen: Screen, *, whole: bool) -> RenderableType:
    """The model, why it works, and the person's own: beside it where there is room and not `whole`."""
    shown, width = found.shown, screen.width or _USUAL
    own = yours.decode("utf-8", "replace").strip("\n") if yours else ""
    programs = [(shown.idea.replace("-", " "), shown.program), *([("yours", own)] if own else [])]
    apart = width < BESIDE or whole or not own
    sides = [Group(strong(name), Text(), *_source(each, folded=apart)) for name, each in programs]
    why = prose(shown.explanation, screen) if shown.explanation else None
    if apart:
        return blocks(None if whole else why, *sides)
    both = Table.grid(padding=(0, 2, 0, 0))
    for _ in sides:
        both.add_column(width=width // 2 - 2, no_wrap=True, overflow="crop")
    both.add_row(*sides)
    return blocks(why, both)


def _source(program: str, *, folded: bool = False) -> list[Text]:
    rows = (printable(row.expandtabs(4)) for row in program.split("\n"))
    return [Text(row, no_wrap=not folded, overflow="fold" if folded else "ignore") for row in rows]


def _beside(found: SolutionShown) -> RenderableType:
    """The other approaches in its language by name, and the other languages."""
    command, shown = f"judge solution {found.problem}", found.shown
    own = [each for each in found.approaches if each.language == shown.language]
    rest = [each.call for each in own if each != shown]
    others = [*dict.fromkeys(each.language for each in found.approaches if each not in own)]
    rows = [(strong(each.call), "the one above" if each == shown else each.about) for each in own]
    below = [(f"{command} {call}", "another approach") for call in rest[:1]]
    below += [(f"{command} --language {each}", "one of them") for each in others[:1]]
    also = [text(f"Also in {', '.join(others)}.")] if others else []
    return blocks(
        table(rows, "approach", "idea") if len(own) > 1 else None,
        Group(*also, commands([*below, (f"{command} --times", "what each takes")])),
    )


def _timed(found: SolutionShown) -> RenderableType:
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
