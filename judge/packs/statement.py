"""A problem's statement as LaTeX, as both formats have it: mistletoe reads the Markdown."""

from __future__ import annotations

import re
from typing import Any

from mistletoe.block_token import Document
from mistletoe.latex_renderer import LaTeXRenderer

from judge.problem import Problem
from judge.run.program import form_of_line
from judge.values.letters import texts_of
from judge.values.reading import meant

# What LaTeX takes for a sign of its own.
_PLAIN = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    **{sign: f"\\{sign}" for sign in "#$%&_{}"},
}
_GREEK = ["Delta", "alpha", "beta", "gamma", "delta", "theta", "lambda", "pi", "rho", "sigma", "tau", "omega"]
# The field's own signs, in text and in a listing, where LaTeX obeys nothing.
_MATHS = {
    "≤": (r"\le", "<="),
    "≥": (r"\ge", ">="),
    "≠": (r"\ne", "!="),
    "≈": (r"\approx", "~"),
    "−": ("-", "-"),
    "±": (r"\pm", "+-"),
    "·": (r"\cdot", "*"),
    "×": (r"\times", "x"),
    "…": (r"\ldots", "..."),
    "√": (r"\surd", "sqrt"),
    "→": (r"\to", "->"),
    "∞": (r"\infty", "inf"),
    "′": ("'", "'"),
    "½": (r"\frac12", "1/2"),
    "∈": (r"\in", "in"),
    "⟂": (r"\perp", "_|_"),
    "ε": (r"\varepsilon", "epsilon"),
    "φ": (r"\varphi", "phi"),
    **{sign: (f"\\{name}", name) for sign, name in zip("Δαβγδθλπρστω", _GREEK, strict=True)},
    **{
        sign: (f"^{{{power}}}", f"^{power}") for sign, power in zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True)
    },
    **{sign: (f"_{{{place}}}", f"_{place}") for sign, place in zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True)},
}
_TEXT = {"–": "--", "—": "---", "“": "``", "”": "''", "‘": "`", "’": "'", "\u00a0": "~"}
_SIGNS = str.maketrans(
    {**_PLAIN, **_TEXT, **{sign: f"\\ensuremath{{{tex}}}" for sign, (tex, _) in _MATHS.items()}}
)
_LISTED = str.maketrans({sign: ascii_ for sign, (_, ascii_) in _MATHS.items()})
_BASE: Any = LaTeXRenderer  # which says nothing of its types
_TITLE = re.compile(r"\A\s*# .*\n")


def latex(problem: Problem) -> str:
    """The whole file problem.en.tex."""
    with _Renderer() as renderer:
        body = renderer.render(Document(_TITLE.sub("", problem.statement)))
    return f"\\problemname{{{escaped(problem.title)}}}\n\n{_as_a_program(problem)}\n{body}"


def escaped(text: str) -> str:
    """Text in which LaTeX sees nothing but text."""
    return text.translate(_SIGNS)


def _as_a_program(problem: Problem) -> str:
    """What a package asks for, where the statement asks for a function."""
    if not problem.entry:
        return ""
    whole = "A submission is a whole program here, and not a function. It reads"
    if problem.formatted:
        return f"\\emph{{{whole} one case, and prints its answer.}}\n"
    quoted = " A text that is empty, has a blank, begins with a quotation mark or is none is a JSON string."
    return (
        f"\\emph{{{whole} the number of cases and then a line for each of them:"
        f" \\texttt{{{escaped(form_of_line(problem))}}}. It prints the answers in the same"
        f" order, one on a line: \\texttt{{{escaped(meant(problem.answer))}}}."
        f"{quoted * any(texts_of(each.type) for each in problem.parameters)}}}\n"
    )


class _Renderer(_BASE):  # type: ignore[misc]
    """The body alone, in the few commands that every reader of packages knows."""

    def render_document(self, token: Any) -> str:
        return str(self.render_inner(token))

    def render_heading(self, token: Any) -> str:
        command = "section" if token.level <= 2 else "subsection"
        return f"\n\\{command}*{{{self.render_inner(token)}}}\n"

    def render_raw_text(self, token: Any, escape: bool = True) -> str:
        return escaped(token.content) if escape else str(token.content)

    def render_inline_code(self, token: Any) -> str:
        return f"\\texttt{{{escaped(token.children[0].content)}}}"

    def render_math(self, token: Any) -> str:
        return escaped(token.content)

    def render_quote(self, token: Any) -> str:
        return f"\\begin{{quote}}\n{self.render_inner(token)}\\end{{quote}}\n"

    def render_strikethrough(self, token: Any) -> str:
        return str(self.render_inner(token))

    def render_image(self, token: Any) -> str:  # noqa: ARG002 - mistletoe's name
        return ""  # a picture is drawn by the judge, and is no file of the package

    def render_block_code(self, token: Any) -> str:
        listing = token.children[0].content.translate(_LISTED)
        return f"\n\\begin{{verbatim}}\n{listing}\\end{{verbatim}}\n"

    render_code_fence = render_block_code

    def render_table(self, token: Any) -> str:
        columns = "l" * (len(token.column_align) - 1) + r"p{0.6\linewidth}"
        head = f"{self.render_table_row(token.header)}\\hline\n" if hasattr(token, "header") else ""
        return f"\n\\begin{{tabular}}{{{columns}}}\n{head}{self.render_inner(token)}\\end{{tabular}}\n"
