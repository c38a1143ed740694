"""What pages show of katas, made once: statement, hints, model solution; the index of explore pages."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

from judge.practice.solutions import approaches
from judge.problem import Problem
from judge.problem.texts import read_hints

_FIGURE = re.compile(r"!\[([^\]]*)\]\(figure\.svg\)")
_REMARK = re.compile(r"(^|<code>)( *)(&gt;&gt;&gt; .*?  +)(# .*)\n", re.MULTILINE)
_INDEX = Path(__file__).parent / "page" / "explore" / "index.html"


def kata_page(problem: Problem) -> dict[str, Any]:
    """The texts of a kata; of a foreign one too, whose raw HTML is shown as text. Raises JudgeError."""
    statement = problem.statement.partition("\n## As a program")[0]
    figure = rf"![\1](kata/{problem.id}.svg)" if has_figure(problem) else ""
    model = approaches(problem)[0]
    return {
        "statement": markdown(_FIGURE.sub(figure, statement)),
        "hints": [{"title": each.title, "html": markdown(each.text)} for each in read_hints(problem)],
        "solution": {"html": markdown(model.explanation), "source": model.program},
    }


def has_figure(problem: Problem) -> bool:
    """Whether its statement has a figure."""
    return (problem.folder / "figure.svg").is_file()


def explore_index(problems: Iterable[Problem]) -> str:
    """The page that lists where the cases of these katas are dragged."""
    tiles = [
        f'<li><a class="tile" href="{each.id}.html">{_picture(each)}<b>{escape(each.title)}</b></a></li>'
        for each in problems
    ]
    return _INDEX.read_text(encoding="utf-8").replace("{{tiles}}", "\n".join(tiles))


def _picture(problem: Problem) -> str:
    picture = f'<img src="../kata/{problem.id}.svg" alt="" loading="lazy">' if has_figure(problem) else "{ }"
    return f'<span class="figure">{picture}</span>'


def markdown(text: str) -> str:
    """Markdown as HTML; HTML in it is escaped, and addresses lead to no script."""
    from mistletoe.block_token import Document
    from mistletoe.html_renderer import HtmlRenderer

    class Escaped(HtmlRenderer):  # its type says nothing of what it renders
        def render_link(self, token: Any) -> str:
            inner, address = self.render_inner(token), str(token.target)
            if not address.startswith(("https://", "http://")):
                return str(inner)
            return f'<a href="{escape(address)}" rel="noopener">{inner}</a>'

        def render_block_code(self, token: Any) -> str:
            return _REMARK.sub(_row, super().render_block_code(token))

    with Escaped(process_html_tokens=False) as renderer:  # type: ignore[no-untyped-call]
        return str(renderer.render(Document(text)))


def _row(example: re.Match[str]) -> str:
    """A call with its remark behind it, or above it where the row is too narrow for both."""
    before, indent, call, remark = example.groups()
    return f'{before}<span class="call"><span>{indent}{call}</span><span>{indent}{remark}</span></span>'
