"""A kata whose answer is one of many words, none of which is nearer to another."""

from __future__ import annotations

import json

import pytest
from cli_support import ROOT

PROBLEMS = ROOT / "tests" / "fixtures" / "calendar" / "problems"


@pytest.fixture(autouse=True)
def _only_these(monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PROBLEMS))


def test_whichever_word_is_wrong_the_smallest_case_is_small(judge, submit):
    source = (PROBLEMS.parent / "solutions" / "weekday" / "accepted" / "zeller.py").read_text()
    wrong = submit(source.replace("- year // 100 + year // 400", "- 15"))
    found = json.loads(judge("run", "weekday", wrong, "--json").out)
    assert found["pitfall"]["name"] == "every-fourth-year"
    assert found["failure"]["input"]["day"] > 1
    assert found["counterexample"]["input"]["day"] == 1


def test_it_is_shown_with_its_words(judge, submit):
    shown = judge("run", "weekday", submit("def weekday(year, month, day):\n    return 'Sunday'\n")).out
    assert "'saturday' wanted, 'Sunday' given" in shown or "wanted  'saturday'" in shown
