"""The questions in the report: what they say, and that they are one page on paper."""

from __future__ import annotations

import io
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest
from chromium import CHROMIUM
from cli_support import ROOT

from judge.kata.checklist import read_checklist

pytestmark = pytest.mark.slow


class Ready(HTMLParser):
    """The words of the section, and the state of each of its entries."""

    def __init__(self, html):
        super().__init__()
        self.inside, self.words, self.states = False, [], []
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.inside = given.get("id") == "ready" if tag == "section" else self.inside
        if self.inside and tag == "li":
            self.states.append(given["class"])

    def handle_data(self, data):
        if self.inside:
            self.words.append(data)

    @property
    def text(self):
        return " ".join(" ".join(self.words).split())


@pytest.fixture
def report(judge, submit, monkeypatch):
    """A report after one accepted kata and two cards, one of which was not known."""
    source = (ROOT / "solutions" / "segment" / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    assert judge("run", "segment", submit(f"{source}# mine\n"), "-q").status == 0
    for card in ("junior/applications", "senior/cull-ratio"):
        monkeypatch.setattr(sys, "stdin", io.StringIO("\n4\n" if card.startswith("junior") else "?\n"))
        assert judge("quiz", "--card", card).status == 0
    assert judge("report", "--no-matrix").status == 0
    return Path("judge-report.html").absolute()


def test_every_question_is_there_with_its_state(report):
    ready = Ready(report.read_text(encoding="utf-8"))
    rows = read_checklist().rows
    assert len(ready.states) == len(rows)
    assert all(f"{row.id}" in ready.text for row in rows)
    state = dict(zip([row.id for row in rows], ready.states, strict=True))
    assert state["M4"] == "passed"  # by the kata
    assert state["J13"] == "passed"  # by the card
    assert (state["S10"], state["P14"]) == ("open", "open")
    assert {state[f"Q{number}"] for number in (2, 9, 14)} == {"open"}
    assert state["Q7"] == "open"  # that of a segment is shown, that of a ray is not
    assert "J13 : Where is it used? Done" in ready.text
    assert re.search(r"Ready\? (\d+) of 14 ticked", ready.text)


def test_a_broken_checklist_costs_the_report_its_questions_only(judge, submit, tmp_path):
    source = (ROOT / "solutions" / "segment" / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    assert judge("run", "segment", submit(source), "-q").status == 0
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "checklist.toml").write_text("sections = 3\nrows = []\n")
    ended = judge("report", "--no-matrix", "--problems", tmp_path / "own")
    assert ended.status == 0
    assert "the questions are left out: own/checklist.toml:1" in ended.err
    assert 'id="ready"' not in Path("judge-report.html").read_text(encoding="utf-8")


@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium (apt-get install chromium)")
def test_the_questions_are_one_page_on_paper(report):
    html = report.read_text(encoding="utf-8")
    start, end = html.index('<section id="ready"'), html.index('<section id="skills"')
    before, after = html.index("<header>"), html.index("</main>")
    alone = report.with_name("alone.html")
    alone.write_text(f"{html[:before]}<main>{html[start:end]}{html[after:].partition('<footer')[0]}")
    command = [
        CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
        f"--user-data-dir={report.parent / 'chromium'}", "--no-pdf-header-footer",
        f"--print-to-pdf={report.parent / 'alone.pdf'}", alone.as_uri(),
    ]  # fmt: skip
    subprocess.run(command, capture_output=True, timeout=120, check=True)
    assert pages((report.parent / "alone.pdf").read_bytes()) == 1


def pages(pdf):
    """How many pages a PDF of Chromium's has."""
    return len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf))
