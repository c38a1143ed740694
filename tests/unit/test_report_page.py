"""The HTML report: what it tells, that it is sound HTML, and that nothing gets out of its place."""

import base64
import hashlib
import re
from datetime import UTC, datetime, timedelta
from html.parser import HTMLParser

import pytest
from msgspec.structs import replace
from past_runs import START, keep

from judge.kata.history import History
from judge.mistakes.told import told_mistakes
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.page.compose import MOST_RUNS, compose_page
from judge.report.page.known import KnownProblem
from judge.report.page.plot import MOST
from judge.report.page.render import is_report, render
from judge.run.result import Failure, GroupResult, Mode, Pitfall, Ratio, Result, Timing

EVIL = (
    "</style></title><script>document.title='pwned'</script>\"'><img src=x onerror=alert(1)>&amp;\x00\u202e"
)
INPUT = {"cx": 0, "cy": 0, "r": 1, "A": [-1, 1], "B": [0, 1]}
VOID = {"meta", "br", "img", "input", "hr", "link", "base", "wbr"}
ACTIVE = {"script", "img", "iframe", "object", "embed", "link"}
ACTIVE |= {"form", "input", "base", "audio", "video", "use"}


def outcome(problem="count", verdict=Verdict.WA, *, mistake=None, ratio=None, name="mine.py", **failure):
    """A result with one passed group and, unless it is accepted, one failed on a case that can be drawn."""
    accepted = verdict is Verdict.AC
    groups = [GroupResult("grid", Verdict.AC, 200, 200, None, 0.01, 100 if accepted else 30)]
    told = None
    if not accepted:
        groups.append(GroupResult("tangent", verdict, 90, 41, None, 0.01, 70))
        case = {"group": "tangent", "case": 3, "input": INPUT, "expected": "1", "got": "2", "message": "off"}
        told = Failure(**{**case, **failure})
    time = Timing(0.02, 0.03, Ratio(ratio, ratio * 0.9, ratio * 1.2, 9) if ratio else None)
    pitfall = Pitfall((mistake,), 0.9, ("Do better.",)) if mistake else None
    return Result(problem, name, Mode.FUNCTION, verdict, tuple(groups), told, time, pitfall=pitfall)


def kept(path, results, source=b"print(1)\n"):
    """The runs that these results make, an hour after another."""
    with History.open(path) as history:
        for hours, result in enumerate(results):
            keep(history, result, source, "/home/somebody/mine.py", START + timedelta(hours=hours))
        return history.runs()


def page_of(runs, names=("count",), sources=None, **settings):
    """A page of these runs and of the shipped problems of those names."""
    problems = [find_problem(name) for name in names]
    advice = [{name: told.advice for name, told in told_mistakes(each).items()} for each in problems]
    known = [KnownProblem(each, said, None) for each, said in zip(problems, advice, strict=True)]
    settings = {"generated": datetime(2026, 3, 9, 12, 0, tzinfo=UTC), "zone": UTC, **settings}
    return compose_page(runs, known, sources or {}, **settings)


def html_of(runs, **settings):
    return render(page_of(runs, **settings)).decode()


class Outline(HTMLParser):
    """What is in a page; raises AssertionError for a tag that is not closed where it must be."""

    def __init__(self, html):
        super().__init__(convert_charrefs=True)
        self.open, self.tags, self.text = [], [], ""
        self.feed(html)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        assert len(attrs) == len(dict(attrs)), (tag, attrs)
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        assert "svg" in self.open, tag  # elsewhere the slash means nothing
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if "style" not in self.open:
            self.text += data


def check_html(html):
    """A page that is well-formed, loads and runs nothing, and whose links lead somewhere in it."""
    outline = Outline(html)
    ids = [attributes["id"] for _, attributes in outline.tags if "id" in attributes]
    assert len(ids) == len(set(ids))
    assert not {tag for tag, _ in outline.tags} & ACTIVE
    for _tag, attributes in outline.tags:
        for name, value in attributes.items():
            assert not name.startswith("on")
            assert name not in ("style", "src", "srcset", "action")
            assert name != "href" or (value[0] == "#" and value[1:] in ids)
            assert name != "aria-labelledby" or set(value.split()) <= set(ids)
    assert "url(" not in html
    assert "@import" not in html
    return outline


@pytest.fixture
def path(tmp_path):
    return tmp_path / "history.sqlite3"


def test_nothing_that_a_submission_says_gets_out_of_its_place(path):
    plain = Outline(html_of(kept(path, [outcome()]), sources={"count": b"x"}, person="Ada"))
    evil = outcome(name=EVIL, mistake=EVIL, got=EVIL, message=EVIL)
    evil = replace(evil, counterexample={"input": None, "expected": EVIL, "got": EVIL, "message": EVIL,
                                         "replay": None})  # fmt: skip
    runs = kept(path.with_name("other"), [evil], EVIL.encode())
    html = html_of(runs, sources={"count": EVIL.encode()}, person=EVIL)
    assert html == html_of(runs, sources={"count": EVIL.encode()}, person=EVIL)
    outline = check_html(html)
    assert outline.text.count("document.title='pwned'") >= 6
    assert "\\x00\\u202e" in outline.text
    assert not set("\x00\u202e") & set(html)
    styles = [[tag for tag, _ in each.tags].count("style") for each in (outline, plain)]
    assert styles[0] == styles[1]


def test_only_the_pages_own_style_sheet_is_allowed(path):
    html = html_of(kept(path, [outcome()]))
    metas = [attributes for tag, attributes in Outline(html).tags if tag == "meta"]
    (policy,) = [each["content"] for each in metas if "http-equiv" in each]
    (sheet,) = re.findall("<style>(.*?)</style>", html, re.DOTALL)
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode()
    allowed = f"style-src 'sha256-{digest}'"
    assert policy == f"default-src 'none'; {allowed}; base-uri 'none'; form-action 'none'"


def test_a_result_of_another_form_is_told_of_without_its_details(path):
    runs = kept(path, [outcome(), outcome(verdict=Verdict.AC, ratio=1.0)])
    broken = [replace(runs[0], packed=b"rubbish"), runs[1]]
    (part,) = page_of(broken).problems
    assert part.cases[0].facts == ()
    assert part.cases[0].drawings == ()
    check_html(html_of(broken))


def test_long_histories_are_cut_and_say_so(path):
    (run,) = kept(path, [outcome(verdict=Verdict.AC, ratio=2.0)])
    many = [replace(run, id=place + 1) for place in range(MOST_RUNS + 40)]
    (part,) = page_of(many).problems
    assert len(part.runs) + len(part.earlier) == MOST_RUNS
    assert part.more == 40
    assert part.plot is not None
    assert len(part.plot.dots) == MOST
    assert part.plot.left_out == MOST_RUNS + 40 - MOST
    html = html_of(many, sources={"count": b"#" * 100_000})
    assert "(the rest is left out)" in html
    assert len(html) < 1_000_000
    check_html(html)


def test_a_report_is_known_by_its_head(path):
    page = html_of(kept(path, [outcome()])).encode()
    assert is_report(page[:2000])
    assert not is_report(b"<!doctype html><title>mine</title>")
    assert not is_report(b"")
