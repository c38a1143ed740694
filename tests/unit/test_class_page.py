"""The page of a class: what is on it, and that nothing a student says is more than text."""

from __future__ import annotations

import re
from datetime import UTC, datetime

import pytest
from classes import ROWS, STUDENTS, class_of, row, small_class

from judge.batch.model import Handin, Student
from judge.batch.representatives import examples, representatives
from judge.judging.job import Terms
from judge.problem.find import find_problem
from judge.problem.verdict import Verdict
from judge.report.cohort.page import is_class_page, render_class
from judge.report.cohort.parts import Example
from judge.report.page.known import KnownProblem

NOW = datetime(2026, 3, 9, 12, 0, tzinfo=UTC)
MARKUP = "</title></style></svg><script>document.title='pwned'</script><img src=x onerror=alert(1)>"


def page(cohort, rows=ROWS, title="geo"):
    """The page with the rows' own cases, of count alone drawn."""
    known = {"count": KnownProblem(find_problem("count"), {"forgotten-abs": "Take its absolute value."})}
    shown = [
        Example(each.problem, each.mistake or each.verdict, each.file, each.result)
        for each in representatives(cohort, rows)
    ]
    return render_class(cohort, shown, known, title=title, generated=NOW)


@pytest.fixture(scope="module")
def html():
    return page(small_class()).decode()


def text(markup):
    """What is read of markup, on one line."""
    return " ".join(re.sub(r"<[^>]*>", " ", markup).split())


def test_the_same_class_gives_the_same_page(html):
    assert page(small_class()).decode() == html
    assert is_class_page(html.encode()[:2000])
    assert not is_class_page(b"<!doctype html><title>mine</title>")
    assert "0" in text(page(class_of(problems=()), ()).decode())


@pytest.fixture(scope="module")
def hostile():
    """A class in which everything that a student can name is markup."""
    who = [Student(MARKUP, MARKUP, MARKUP), *STUDENTS]
    rows = [
        row(MARKUP, "count", MARKUP, ("grid",), file=f"{MARKUP}.py", machine=MARKUP, busy=MARKUP),
        row("ann", "count", MARKUP, ("grid",), file="2.py"),
        row("bob", MARKUP, verdict=Verdict.JE),
    ]
    return page(class_of(*rows, students=who, problems=("count", MARKUP)), rows, title=MARKUP)


def test_markup_is_text(hostile):
    html = hostile.decode()
    assert html.count("pwned") > 10
    assert not re.findall(r"<script|<img| on\w+=\"| style=\"", html)
    (policy,) = re.findall(r'Policy" content="([^"]*)"', html)
    assert policy.startswith("default-src &#39;none&#39;; style-src &#39;sha256-")
    assert not re.findall(r'(?:src|href)="(?!#)', html)


@pytest.mark.nightly
def test_the_smallest_case_of_one_hand_in_of_each_mistake():
    middle = find_problem("count")
    source = b"def line_count(cx, cy, r, A, B):\n    return 2\n"
    row_ = row("ann", "count", "one-answer", ("grid",))
    other = row("bob", "count", "one-answer", ("grid",))
    compiled = row("cid", "count", verdict=Verdict.CE)
    cohort = class_of(row_, other, compiled)
    chosen = representatives(cohort, [row_, other, compiled])
    assert [each.file for each in chosen] == ["ann/count.py", "cid/count.py"]
    handins = [Handin("ann", "count", "ann/count.py", source)]
    one, two = examples(chosen, handins, {"count": middle}, Terms(("grid",)))
    assert (one.label, two.label) == ("one-answer", "CE")
    assert one.published["counterexample"]["replay"].startswith("count:")
    assert one.published["pitfall"]["name"] == "one-answer"
    assert set(one.advice) == {"one-answer"}
    assert (two.published, two.advice) == (compiled.result, {})
