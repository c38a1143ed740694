"""The questions in the report, and the state of each."""

from __future__ import annotations

import io
import re
import sys
from pathlib import Path

import pytest
from cli_support import ROOT

from judge.kata.checklist import read_checklist

pytestmark = pytest.mark.slow


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


def test_a_broken_checklist_costs_the_report_its_questions_only(judge, submit, tmp_path):
    source = (ROOT / "solutions" / "segment" / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    assert judge("run", "segment", submit(source), "-q").status == 0
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "checklist.toml").write_text("sections = 3\nrows = []\n")
    ended = judge("report", "--no-matrix", "--problems", tmp_path / "own")
    assert ended.status == 0
    assert "the questions are left out: own/checklist.toml:1" in ended.err
    assert 'id="ready"' not in Path("judge-report.html").read_text(encoding="utf-8")
