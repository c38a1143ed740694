"""The HTML pages: what they say, that they are sound HTML, and that nothing gets out of its place."""

from __future__ import annotations

import base64
import hashlib
import re
from datetime import UTC, datetime, timedelta
from html.parser import HTMLParser

import pytest
from classes import ROWS, STUDENTS, class_of, row, small_class
from msgspec.structs import replace
from past_runs import START, keep, past_result

from judge.batch.cohort import samples
from judge.practice.history import History
from judge.problem.find import find_problem
from judge.problem.model import Verdict
from judge.report.html import is_page
from judge.report.html.pages import CLASS_MARK, FEEDBACK_MARK, ClassPages, ShownCases
from judge.report.published_klass import Student
from judge.run.result import Failure

NOW = datetime(2026, 3, 9, 12, 0, tzinfo=UTC)
EVIL = (
    "</style></title><script>document.title='pwned'</script>\"'><img src=x onerror=alert(1)>&amp;\x00\u202e"
)
INPUT = {"cx": 0, "cy": 0, "r": 1, "A": [-1, 1], "B": [0, 1]}
VOID = {"meta", "br", "img", "input", "hr", "link", "base", "wbr"}
ACTIVE = {"script", "img", "iframe", "object", "embed", "link"}
ACTIVE |= {"form", "input", "base", "audio", "video", "use"}


def outcome(problem="count", *, solved=False, mistake=None, ratio=None, name="mine.py", **failure):
    """A result with one passed group and, unless it is solved, one failed on a case that can be drawn."""
    if solved:
        return past_result(problem, name=name, ratio=ratio)
    case = {"group": "tangent", "case": 3, "input": INPUT, "expected": "1", "got": "2", "message": "off"}
    failed = past_result(problem, ("grid",), ("tangent",), name=name, mistake=mistake, ratio=ratio)
    return replace(failed, failure=Failure(**{**case, **failure}))


def kept(path, results, source=b"print(1)\n"):
    """The runs that these results make, a day after another."""
    with History(path) as history:
        for number, result in enumerate(results):
            keep(history, result, source, "/home/somebody/mine.py", START + timedelta(days=number))
        return history.runs()


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
        self.text += " "
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


def checked(html):
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
    assert not set("\x00\u202e") & set(html)
    (sheet,) = re.findall("<style>(.*?)</style>", html, re.DOTALL)
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode()
    (policy,) = [each["content"] for tag, each in outline.tags if tag == "meta" and "http-equiv" in each]
    allowed = f"default-src 'none'; style-src 'sha256-{digest}'"
    assert policy == f"{allowed}; base-uri 'none'; form-action 'none'"
    return outline


@pytest.fixture
def path(tmp_path):
    return tmp_path / "history.sqlite3"


# -- classes -----------------------------------------------------------------------------------------------


def pages_of(cohort, rows, title="geo"):
    """The page of a class, of which count alone is there, and the pages of its students by file."""
    problems = {"count": find_problem("count")}
    results = {(each.problem, each.file): each.result for each in rows}
    pages = ClassPages(cohort, results, ShownCases(problems), title, NOW)
    return pages.whole().decode(), {name: pages.student(at).decode() for at, name in enumerate(pages.files())}


def test_the_page_of_a_class():
    cohort = small_class()
    html, _ = pages_of(cohort, samples(cohort, ROWS))
    assert html == pages_of(cohort, samples(cohort, ROWS))[0]
    assert is_page(html.encode()[:2000], CLASS_MARK)
    text = " ".join(checked(html).text.split())
    assert "students 6" in text
    assert "zoe not found on the list" in text
    assert "count, forgotten-abs: Bob\\x1b[31m" in text  # stuck
    assert "Nothing submitted <script>alert(1)</script>" in text
    assert "count: 4 of 6 submitted, 1 accepted" in text
    assert "identical after removing names, spacing and comments: Bob\\x1b[31m, =HYPERLINK(1)" in text
    assert html.count('<article id="kata-2-case-') == 2  # of each mistake on count one case
    assert html.count('<figure class="drawing"') == 2


def test_a_large_class_is_one_table_in_parts():
    cohort = class_of(*(row(f"s{at:03}", "count") for at in range(250)))
    html, _ = pages_of(cohort, ())
    assert [each.count('<th scope="row">') for each in html.split('<table class="marks">')[1:]] == [
        100,
        100,
        50,
    ]
    assert "for each kata, part 3 of 3" in checked(html).text
    assert html.count('role="region"') == html.count('class="scroller tall"') == 1
    small, _ = pages_of(small_class(), ())
    assert "part 1" not in small
    assert 'class="scroller"' in small


def test_the_page_of_a_student_has_nothing_of_others():
    _, pages = pages_of(small_class(), ROWS)
    assert list(pages) == ["ann.html", "bob.html", "cid.html", "dee__31m王.html", "eve.html", "zoe.html"]
    for html in pages.values():
        assert is_page(html.encode()[:2000], FEEDBACK_MARK)
        checked(html)
    assert "forgotten-abs" in pages["bob.html"]
    assert "bob/count-" in pages["bob.html"]
    for other in ("Ann Lee", "HYPERLINK", "cid/", "tangent-twice"):
        assert other not in pages["bob.html"]
    text = " ".join(Outline(pages["ann.html"]).text.split())
    assert "katas solved 1 of 2 points of 200 120" in text


def test_what_could_not_be_judged_says_why_and_has_no_case():
    rows = [row("ann", "count", verdict=Verdict.JE)]
    html, pages = pages_of(class_of(*rows, students=[Student("ann")]), rows)
    for page in (html, pages["ann.html"]):
        assert "count.py: line 1: '(' was never closed" in checked(page).text
        assert not re.findall("case-1|Nothing was submitted|Nothing submitted", page)


def test_the_reason_for_several_holds_for_each_and_the_most_frequent_is_first():
    same = [row(who, "count", verdict=Verdict.CE) for who in ("ann", "bob", "cid")]
    broken = row("dee", "count", verdict=Verdict.RTE, fails=("grid",))
    other = row("eve", "count", verdict=Verdict.RTE, fails=("tangent",))
    for each, why in ((broken, "IndexError"), (other, "KeyError")):
        each.done.result["failure"]["message"] = why
    rows = [*same, broken, other, row("fay", "count", "forgotten-abs", ("grid",))]
    html, _ = pages_of(class_of(*rows), rows)
    assert re.findall(r'<h3 id="kata-1-case-\d-heading">(.*?)</h3>', html) == [
        "Does not compile",
        "Run-time error",
        "forgotten-abs",
    ]
    assert "was never closed" in html
    assert "The case of dee:" in checked(html).text
    assert not re.findall("IndexError|KeyError|Run-time error, grid", html)


def test_a_student_may_be_called_anything():
    ids = ["../../etc/passwd", "a/b", "a_b", "A_B", "..", "", "x" * 300, EVIL]
    rows = [row(who, "count", EVIL, ("grid",), file=f"{EVIL}{at}.py") for at, who in enumerate(ids)]
    students = [*(Student(who, EVIL, EVIL) for who in ids), *STUDENTS]
    html, pages = pages_of(class_of(*rows, students=students), rows, EVIL)
    assert checked(html).text.count("document.title='pwned'") > 10
    assert len(pages) == len({name.casefold() for name in pages}) == len(students)
    for at, (name, page) in enumerate(pages.items()):
        assert re.fullmatch(r"[^./\\<>\x00][^/\\<>\x00]{0,70}\.html", name)
        assert ("Nothing was submitted." in page) is (at >= len(ids))
        assert at >= len(ids) or checked(page).text.count("document.title='pwned'") >= 4


def test_no_other_page_is_written_over():
    html, pages = pages_of(small_class(), ROWS)
    assert not is_page(html.encode(), FEEDBACK_MARK)
    assert not is_page(pages["bob.html"].encode(), CLASS_MARK)
    assert not is_page(b"<!doctype html><title>mine</title>", CLASS_MARK)
    assert not is_page(b"", CLASS_MARK)
    older = b'<!doctype html>\n<meta name="generator" content="judge class page, judge 0.1.0">'
    assert is_page(older, CLASS_MARK)
