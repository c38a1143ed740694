"""`judge report`: where the page goes, what it must not overwrite, and what the command says."""

from __future__ import annotations

import io
import re
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT

from judge.kata.checklist import read_checklist

pytestmark = pytest.mark.slow

USUAL = Path("judge-report.html")


@pytest.fixture
def judged(judge, submit):
    """A history of two runs: the floor, then the mean."""
    assert judge("run", "middle", submit(FLOOR), "--no-shrink").status == 1
    assert judge("run", "middle", submit(MEAN)).status == 0


def test_it_writes_the_page_and_says_where(judge, judged):
    ended = judge("report")
    assert (ended.status, ended.out, ended.err) == (0, "judge-report.html\n", "")
    page = USUAL.read_text(encoding="utf-8")
    assert "solved on" in page
    assert "floor-division" in page
    assert "yours, 1 ×" in page  # in the kill matrix
    assert "(a + b) / 2" in page  # the last source
    assert USUAL.stat().st_mode & 0o777 == 0o644
    assert [path.name for path in Path().iterdir() if path.suffix == ".tmp"] == []


def test_it_may_be_made_again_and_is_the_same(judge, judged, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1800000000")
    assert judge("report").status == 0
    first = USUAL.read_bytes()
    assert judge("report").status == 0
    assert USUAL.read_bytes() == first
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "soon")
    assert "$SOURCE_DATE_EPOCH: 'soon' is no time" in judge("report").err


def test_what_is_no_report_is_not_overwritten(judge, judged):
    USUAL.write_text("<!doctype html><title>precious</title>")
    ended = judge("report")
    assert ended.status == 2
    assert ended.err == (
        "judge: judge-report.html: it is there already and is no report; "
        "name another file with --out, or overwrite it with --force\n"
    )
    assert "precious" in USUAL.read_text()
    assert judge("report", "--force").status == 0
    assert "precious" not in USUAL.read_text(encoding="utf-8")


def test_a_problem_that_cannot_be_read_any_more(judge, judged, tmp_path):
    (tmp_path / "pack" / "broken").mkdir(parents=True)
    (tmp_path / "pack" / "broken" / "problem.toml").write_text("title = 1")
    ended = judge("report", "--problems", "pack")
    assert ended.status == 0
    assert "a problem is left out: broken/problem.toml:1: " in ended.err
    assert USUAL.exists()


# -- the questions ---------------------------------------------------------------------------------------


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
    page = report.read_text(encoding="utf-8")
    ready = page[page.index('<section id="ready"') : page.index('<section id="skills"')]
    rows = [row.id for row in read_checklist().rows]
    states = re.findall(r'<li class="(\w+)"', ready)
    state = dict(zip(rows, states, strict=True))
    assert state["M4"] == "passed"  # by the kata
    assert state["J13"] == "passed"  # by the card
    assert {state[name] for name in ("S10", "P14", "Q2", "Q9", "Q14")} == {"open"}
    assert state["Q7"] == "open"  # that of a segment is shown, that of a ray is not
    assert re.search(r"Ready\?", ready)


def test_a_broken_checklist_costs_the_report_its_skills_and_questions_only(judge, submit, tmp_path):
    source = (ROOT / "solutions" / "segment" / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    assert judge("run", "segment", submit(source), "-q").status == 0
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "checklist.toml").write_text("sections = 3\nrows = []\n")
    ended = judge("report", "--no-matrix", "--problems", tmp_path / "own")
    assert ended.status == 0
    assert "skills and questions are left out: own/checklist.toml:1" in ended.err
    assert 'id="ready"' not in Path("judge-report.html").read_text(encoding="utf-8")
