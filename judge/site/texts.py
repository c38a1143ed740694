"""What a page shows of a kata, made once: its statement, hints and model solution as HTML, its cards."""

from __future__ import annotations

import re
from html import escape

from msgspec import Struct

from judge.practice.model import approaches
from judge.problem import Problem
from judge.problem.texts import read_hints

_FIGURE = re.compile(r"!\[([^\]]*)\]\(figure\.svg\)")


class Text(Struct, frozen=True):
    """A piece of text under its title."""

    title: str
    html: str
    source: str = ""


class KataPage(Struct, frozen=True):
    """The texts of one kata."""

    statement: str
    hints: tuple[Text, ...]
    solution: Text | None


def kata_page(problem: Problem) -> KataPage:
    """The texts of a kata; of a foreign one too, whose raw HTML is shown as text. Raises JudgeError."""
    statement = problem.statement.partition("\n## As a program")[0]
    first = approaches(problem)[0]
    return KataPage(
        markdown(_FIGURE.sub(rf"![\1](kata/{problem.id}.svg)", statement)),
        tuple(Text(each.title, markdown(each.text)) for each in read_hints(problem)),
        Text(first.idea, markdown(first.explanation), first.program),
    )


def markdown(text: str) -> str:
    """Markdown as HTML; HTML in it is escaped, and addresses lead to no script."""
    import mistletoe
    from mistletoe.html_renderer import HtmlRenderer

    class Escaped(HtmlRenderer):  # type: ignore[misc]
        """Without the two tokens that pass HTML through."""

        def render_link(self, token: object) -> str:
            address = str(getattr(token, "target", ""))
            inner: str = self.render_inner(token)
            if not address.startswith(("https://", "http://", "#")):
                return inner
            return f'<a href="{escape(address)}" rel="noopener">{inner}</a>'

    with Escaped(process_html_tokens=False) as renderer:
        found: str = renderer.render(mistletoe.Document(text))
    return found
