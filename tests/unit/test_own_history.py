"""The terminal's history as the page of a served site joins it with its own."""

from __future__ import annotations

import json
from datetime import timedelta

from past_runs import START, keep, past_result

from judge.practice.history import History
from judge.practice.syllabus import read_checklist
from judge.problem.find import find_problem
from judge.site.serve import own_history


def test_the_terminals_own_history_is_there(tmp_path):
    count = find_problem("count")
    groups = [each.name for each in count.groups]
    with History(tmp_path / "history.sqlite3") as history:
        keep(history, past_result("count", groups[:1], groups[1:]))
        keep(history, past_result("count", groups), when=START + timedelta(days=1))
        found = json.loads(own_history(history, [count, find_problem("segment")], read_checklist().skills))
    assert found["katas"] == {"count": {"stars": 2, "tries": 2, "hints": 0, "solved": "2026-03-02T09:00:00Z"}}
    assert len(found["days"]) == 2
    assert {each.name for each in count.skills} <= {*found["skills"]}
