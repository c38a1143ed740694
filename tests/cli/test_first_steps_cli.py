"""A newcomer's path: from `judge next` to the first skill, in plain words."""

from __future__ import annotations

import json
import re
from pathlib import Path

from judge.problem.find import find_problem

CARET = """
def distance_squared(P, Q):
    dx, dy = P[0] - Q[0], P[1] - Q[1]
    return dx ^ 2 + dy ^ 2
"""
RIGHT = CARET.replace("^", "**")
PLAIN = re.compile(r"(?<![a-z])(bands?|epsilons?|tolerances?|extent|threshold)(?![a-z])", re.IGNORECASE)


def test_the_first_acceptance_ticks_a_skill_and_next_goes_on(judge, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    screens = [judge("next", "--init")]
    file = Path("distance_squared.py")
    assert "def distance_squared(P: IntPoint, Q: IntPoint) -> int:" in file.read_text(encoding="utf-8")
    file.write_text(CARET, encoding="utf-8")
    screens.append(judge("run"))
    assert screens[-1].status == 1
    assert "caret-for-power  likely" in screens[-1].out
    assert "The square of d is `d * d` or `d ** 2`." in " ".join(screens[-1].out.split())
    screens.append(judge("hint"))
    file.write_text(RIGHT, encoding="utf-8")
    screens.append(judge("run"))
    assert screens[-1].status == 0
    screens += [judge("progress", "first-steps"), judge("practice", "first-steps"), judge("list")]
    skills = json.loads(judge("progress", "first-steps", "--json").out)["skills"]
    assert (skills[0]["name"], skills[0]["state"]) == ("distance squared", "shown")
    assert {each["state"] for each in skills[1:]} == {"open"}
    assert json.loads(judge("practice", "first-steps", "--json").out)["current"]["problem"] == "which-side"
    for screen in screens[:-1]:
        assert PLAIN.findall(screen.out) == []
    names = [line.split()[0] for line in screens[-1].lines[1:]]
    assert names[0] == "distance-squared"
    assert names.index("crossings") < names.index("count")


def test_every_wrong_answer_of_a_first_step_is_told_in_plain_words(judge, submit):
    for problem in ("which-side", "circle-side", "diameter", "axis-foot", "crossings"):
        shown = find_problem(problem)
        arguments = ", ".join(each.name for each in shown.parameters)
        file = submit(f"def {shown.entry}({arguments}):\n    return 5\n")
        ended = judge("run", problem, file)
        assert ended.status == 1
        assert PLAIN.findall(ended.out) == [], problem
        assert (
            PLAIN.findall(judge("show", problem).out.replace("Tolerance\n  none: the exact answer", "")) == []
        )
