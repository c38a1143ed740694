"""A result as a notebook shows it: what the screen says, and the drawing of the failing case."""

from __future__ import annotations

from contextlib import suppress
from html import escape

from judge.drawing.svg import style
from judge.errors import JudgeError
from judge.problem.find import find_problem
from judge.report.html.case import Cases, Drawing
from judge.report.tell import tell
from judge.report.words import printable, shown_name
from judge.run.result import Result

_SIDE = 260  # pixels of a drawing


def notebook(result: Result) -> str:
    """An element of HTML with its own style sheet; of a kata that is not found, without a drawing."""
    told, anchor = tell(None, result), f"judge-{id(result):x}"
    head = f"{told.verdict.value}  {told.meaning}  {shown_name(result.submission)}  {told.stars}".rstrip()
    text = "\n".join(escape(printable(line)) for line in (*told.lines, told.last))
    drawings = "".join(
        f'<figure style="width:{_SIDE}px;display:inline-block;margin:1em">{each.svg}'
        f"<figcaption>{escape(each.title)}</figcaption></figure>"
        for each in _drawings(result, anchor)
    )
    words = f'<strong>{escape(printable(head))}</strong><pre style="white-space:pre-wrap">{text}</pre>'
    return f'<div id="{anchor}"><style>{style(f"#{anchor} figure")}</style>{words}{drawings}</div>'


def _drawings(result: Result, anchor: str) -> tuple[Drawing, ...]:
    with suppress(JudgeError):
        problem = find_problem(result.problem)
        return Cases({problem.id: problem}).tell(problem.id, result.verdict, "", result, anchor).drawings
    return ()
