"""A hint, and a model solution with the approaches beside it, on a screen."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.text import Text

from judge.report.parts import FAINT, GOOD, STRONG, commands, joined, table, text
from judge.report.published_practice import HintShown, SolutionShown
from judge.report.screen import Screen, is_terminal
from judge.report.statement import prose
from judge.report.words import printable, seconds, shown_name, times
from judge.run.result import Taken


def hint(found: HintShown, screen: Screen) -> RenderableType:
    """The hint under its title; after the last one, what is left to do."""
    place = text(f"{found.problem}, hint {found.step} of {found.steps}", FAINT)
    head = table(("", ""), [(text(found.title, STRONG), place)])
    parts: list[RenderableType] = [head, Text(), prose(found.text, screen), Text()]
    if found.step == found.steps:
        parts.append(text("That was the last hint."))
        parts.append(commands([(f"judge solution {found.problem} --give-up", "the solution")]))
    return Group(*parts)


def solution(found: SolutionShown, screen: Screen) -> RenderableType:
    """Its idea, why it works, and the program, whose lines are never broken: they can be copied."""
    head = joined(text(f"{found.problem}: {found.idea.replace('-', ' ')}", STRONG), f"  {found.file}")
    explained = [prose(found.explanation, screen), Text()] if found.explanation else []
    rows = [printable(row.expandtabs(4)) for row in found.program.split("\n")]
    if not is_terminal(screen.stream):
        rows = [f"```{found.code}", *rows, "```"]
    code = [Text(row, no_wrap=True, overflow="ignore") for row in rows]
    timed = found.approaches[0].taken
    return Group(head, Text(), *explained, *code, Text(), *([_timed(found)] if timed else _beside(found)))


def _beside(found: SolutionShown) -> Iterator[RenderableType]:
    """The other approaches in its language by name, and the other languages."""
    own = [each for each in found.approaches if each.language == found.language]
    others = dict.fromkeys(each.language for each in found.approaches if each.language != found.language)
    if len(own) > 1:
        rows = [
            (text(each.call, STRONG), "the one above" if each.file == found.file else each.about)
            for each in own
        ]
        yield table(("approach", "idea"), rows)
        yield Text()
    if others:
        yield text(f"Also in {', '.join(others)}.")
    below = [(f"judge solution {found.problem} {each.call}", "another approach") for each in own]
    below = [each for each, row in zip(below, own, strict=True) if row.file != found.file][:1]
    below += (
        [(f"judge solution {found.problem} --language {next(iter(others))}", "one of them")] if others else []
    )
    yield commands([*below, (f"judge solution {found.problem} --times", "what each takes")])


def _timed(found: SolutionShown) -> RenderableType:
    """What each approach takes for one case, the person's own last."""
    rows = [(text(each.call, STRONG), each.language, *_taken(each.taken)) for each in found.approaches]
    if own := found.yours:
        which = text(f"run {own.run}, {shown_name(own.file)}", FAINT)
        rows.append((text("yours", GOOD), "", *_taken(own.taken)[:2], which))
    titles = ("approach", "language", "CPU, one case", f"× {found.approaches[0].call}", "")
    return table(titles, rows, right=[2, 3])


def _taken(taken: Taken | None) -> tuple[str, str, Text]:
    """CPU seconds of a case, which are often few microseconds, the ratio, and why there are none."""
    if taken is None or taken.seconds is None:
        return "", "", text(taken.why_not if taken else "", FAINT)
    short = f"{1e6 * taken.seconds:.3g} µs" if taken.seconds < 1e-3 else seconds(taken.seconds)
    return short, times(taken.ratio) if taken.ratio is not None else "", Text()
