"""The pictures of the katas in README, a picture for each level. Run as a script, it draws them anew.

A kata is shown as the judge draws one of its worked examples, without words; one that has no picture, by its
own title.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from walk import ROOT

from judge.drawing import Picture
from judge.drawing.svg import panel_svg, style, words
from judge.problem import Problem
from judge.problem.declare import Shown
from judge.problem.find import find_problem
from judge.problem.module import load_module
from judge.values import check, show

FOLDER = ROOT / ".github" / "katas"
_ROW = re.compile(r"^\| ([a-z ]+): [^|]*\| !\[[^|]*\) (`[^|]*`) \|", re.MULTILINE)
_IN_A_ROW, _SIDE, _GAP, _NAME = 6, 132, 12, 24
_SMALL = """
text{font:12px system-ui,'Segoe UI','DejaVu Sans',sans-serif;fill:#57606a;text-anchor:middle}
.panel{rx:24px}
.circle,.line,.beyond,.wanted{vector-effect:non-scaling-stroke}
.case{r:7px}
circle.wanted{r:14px}
@media (prefers-color-scheme:dark){text{fill:#8d96a0}}
"""


def levels() -> dict[str, list[str]]:
    """The katas of each row of README's table."""
    page = (ROOT / "README.md").read_text(encoding="utf-8")
    return {level: re.findall(r"`([\w-]+)`", katas) for level, katas in _ROW.findall(page)}


def path_of(level: str) -> Path:
    """Where the picture of a level's katas is kept."""
    return FOLDER / f"{level.replace(' ', '-')}.svg"


def gallery(level: str, katas: Sequence[str]) -> str:
    """The katas side by side, each with its name."""
    rows = -(-len(katas) // _IN_A_ROW)
    width, height = _IN_A_ROW * (_SIDE + _GAP) - _GAP, rows * (_SIDE + _NAME + _GAP) - _GAP
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="the katas: {words(level)}" '
        f'viewBox="0 0 {width} {height}" width="{width}" height="{height}">'
    )
    parts = [head, f"<style>{style()}{_SMALL}</style>"]
    for place, kata in enumerate(katas):
        row, column = divmod(place, _IN_A_ROW)
        left, top = column * (_SIDE + _GAP), row * (_SIDE + _NAME + _GAP)
        problem = find_problem(kata)
        parts.append(f'<g transform="translate({left} {top})">')
        parts += _thumbnail(problem)
        parts.append(_text(_SIDE + 17, kata))
        parts.append("</g>")
    return "\n".join([*parts, "</svg>"]) + "\n"


def _thumbnail(problem: Problem) -> list[str]:
    picture = _best(problem)
    if picture is None:
        lines = _wrapped(problem.title)
        first = _SIDE / 2 - 8 * (len(lines) - 1) + 4
        return [
            f'<rect class="panel" style="rx:8px" width="{_SIDE}" height="{_SIDE}"/>',
            *(_text(first + 16 * at, each) for at, each in enumerate(lines)),
        ]
    drawn = panel_svg(picture.whole, "whole", "").splitlines()[3:]
    kept = [part for part in drawn if not re.match(r'<text|<path class="(bar|leader)"', part)]
    box = f'<svg width="{_SIDE}" height="{_SIDE}" viewBox="-1 -1 402 402">'
    return [box, *kept]


def _text(y: float, text: str) -> str:
    return f'<text x="{_SIDE / 2:g}" y="{y:g}">{words(text)}</text>'


def _best(problem: Problem) -> Picture | None:
    """Of the examples' pictures the one with most in it, the first of several."""
    module = load_module(problem)
    draw = module.hooks.picture
    if draw is None:
        return None
    pictures = []
    for example in problem.examples:
        exact = module.solve(*example.case)
        wanted = show.wanted(problem.answer, check.target(problem.answer, exact, problem.groups[0].tolerance))
        picture = draw(Shown(problem, problem.named(example.case), exact, wanted, None))
        if picture is not None:
            pictures.append(picture)
    return max(pictures, key=lambda each: len(each.whole.marks) + len(each.whole.strokes), default=None)


def _wrapped(text: str) -> list[str]:
    rows = [""]
    for word in text.split():
        if rows[-1] and len(rows[-1]) + len(word) > 15:
            rows.append(word)
        else:
            rows[-1] = f"{rows[-1]} {word}".strip()
    return rows


def main() -> None:
    """Draw the pictures anew."""
    FOLDER.mkdir(exist_ok=True)
    for level, katas in levels().items():
        path_of(level).write_text(gallery(level, katas), encoding="utf-8")


if __name__ == "__main__":
    main()
