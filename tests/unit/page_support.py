"""Histories to make pages of, and a reader that holds a page to the rules of HTML."""

from __future__ import annotations

import re
from datetime import UTC, datetime
from functools import cache
from html.parser import HTMLParser

from past_runs import StoppedClock

from judge.kata.history import History
from judge.mistakes.told import told_mistakes
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.page.compose import compose_page
from judge.report.page.known import KnownProblem
from judge.report.page.render import render
from judge.run.result import Failure, GroupResult, Mode, Pitfall, Ratio, Result, Timing

GENERATED = datetime(2026, 3, 9, 12, 0, tzinfo=UTC)
INPUT = {"cx": 0, "cy": 0, "r": 1, "A": [-1, 1], "B": [0, 1]}
VOID = {"meta", "br", "img", "input", "hr", "link", "base", "wbr"}


def outcome(problem="count", verdict=Verdict.WA, *, mistake=None, ratio=None, name="mine.py", **failure):
    """A result with one passed group and, unless it is accepted, one failed on a case that can be drawn."""
    accepted = verdict is Verdict.AC
    groups = [GroupResult("grid", Verdict.AC, 200, 200, None, 0.01, 100 if accepted else 30)]
    told = None
    if not accepted:
        groups.append(GroupResult("tangent", verdict, 90, 41, None, 0.01, 70))
        case = {"group": "tangent", "case": 3, "input": INPUT, "expected": "1", "got": "2", "message": "off"}
        told = Failure(**{**case, **failure})
    return Result(
        problem,
        name,
        Mode.FUNCTION,
        verdict,
        tuple(groups),
        told,
        Timing(0.02, 0.03, Ratio(ratio, ratio * 0.9, ratio * 1.2, 9) if ratio else None),
        pitfall=Pitfall((mistake,), 0.9, ("Do better.",)) if mistake else None,
    )


def kept(path, results, source=b"print(1)\n"):
    """The runs that these results make, an hour after another."""
    clock = StoppedClock()
    with History.open(path, clock=clock) as history:
        for result in results:
            history.add(result, source, "/home/somebody/mine.py")
            clock.forward(hours=1)
        return history.runs()


def known(*names, matrix=None):
    """The shipped problems of those names, as `judge report` knows them."""
    return [KnownProblem(find_problem(name), _advice(name), matrix) for name in names]


@cache
def _advice(name):
    return {mistake: told.advice for mistake, told in told_mistakes(find_problem(name)).items()}


def page_of(runs, problems=None, sources=None, **settings):
    """A page of these runs, in UTC if nothing else is said."""
    problems = known("count") if problems is None else problems
    settings = {"generated": GENERATED, "zone": UTC, **settings}
    return compose_page(runs, problems, sources or {}, **settings)


def html_of(runs, problems=None, sources=None, **settings):
    return render(page_of(runs, problems, sources, **settings)).decode()


class Outline(HTMLParser):
    """What is in a page; raises AssertionError for a tag that is not closed where it must be."""

    def __init__(self, html):
        super().__init__(convert_charrefs=True)
        self.open = []
        self.tags = []  # (name, attributes)
        self.text = ""
        self.headings = []
        self.feed(html)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), (tag, names)
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))

    def handle_startendtag(self, tag, attrs):
        assert "svg" in self.open, tag  # elsewhere the slash means nothing
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open, tag
        assert self.open.pop() == tag

    def handle_data(self, data):
        if "style" not in self.open:
            self.text += data

    def all(self, name):
        return [attributes for tag, attributes in self.tags if tag == name]

    @property
    def ids(self):
        return [attributes["id"] for _, attributes in self.tags if "id" in attributes]


def check_html(html):
    """A page that is well-formed, loads and runs nothing, and can be found one's way in without eyes."""
    outline = Outline(html)
    assert len(outline.ids) == len(set(outline.ids))
    assert not {tag for tag, _ in outline.tags} & {
        "script", "img", "iframe", "object", "embed", "link", "form", "input", "base", "audio", "video", "use"
    }  # fmt: skip
    for _tag, attributes in outline.tags:
        for name, value in attributes.items():
            assert not name.startswith("on")
            assert name not in ("style", "src", "srcset", "action")
            if name == "href":
                assert value[0] == "#", value
                assert value[1:] in outline.ids
            if name == "aria-labelledby":
                assert set(value.split()) <= set(outline.ids), value
    assert "url(" not in html
    assert "@import" not in html
    _check_way_around(outline)
    return outline


def _check_way_around(outline):
    (html,) = outline.all("html")
    assert html["lang"] == "en"
    assert outline.headings.count(1) == 1
    assert all(b - a <= 1 for a, b in zip(outline.headings, outline.headings[1:], strict=False))
    for landmark in ("header", "nav", "main", "footer"):
        assert len(outline.all(landmark)) == 1
    assert len(outline.all("table")) == len(outline.all("caption"))
    assert all(cell.get("scope") in ("row", "col") for cell in outline.all("th"))
    first_link = outline.all("a")[0]
    assert first_link == {"class": "skip", "href": "#main"}
    for attributes in outline.all("svg"):
        if attributes.get("role") == "img":
            assert attributes.get("aria-labelledby") or attributes.get("aria-label")
