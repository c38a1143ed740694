"""What a page shows of a kata, made once: its statement, hints and model solution as HTML."""

from __future__ import annotations

import re
from html import escape
from typing import Any

from judge.practice.solutions import approaches
from judge.problem import Problem
from judge.problem.texts import read_hints

_FIGURE = re.compile(r"!\[([^\]]*)\]\(figure\.svg\)")


def kata_page(problem: Problem) -> dict[str, Any]:
    """The texts of a kata; of a foreign one too, whose raw HTML is shown as text. Raises JudgeError."""
    statement = problem.statement.partition("\n## As a program")[0]
    model = approaches(problem)[0]
    return {
        "statement": markdown(_FIGURE.sub(rf"![\1](kata/{problem.id}.svg)", statement)),
        "hints": [{"title": each.title, "html": markdown(each.text)} for each in read_hints(problem)],
        "solution": {"html": markdown(model.explanation), "source": model.program},
    }


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

    with Escaped(process_html_tokens=False) as renderer:  # type: ignore[no-untyped-call]
        return str(renderer.render(Document(text)))
