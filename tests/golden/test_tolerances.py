"""A program with a tolerance is right with each from 1e-12 to 5e-8 of the size, and wrong with 1e-5."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sampling import daily

from judge.data.load import load_data
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run import Settings, judge_submission

SOLUTIONS = Path(__file__).parents[2] / "solutions"
COMPARED = re.compile(r"\b1e-[89] \* ")  # the usual tolerance, or the widest that there is
# The tolerance of `shadow` is how far off the surface a second ray starts, which may not be so small.
KATAS = sorted({path.parents[1].name for path in SOLUTIONS.glob("*/accepted/tolerant.py")} - {"shadow"})

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("kata", daily(KATAS, ["count", "circle-circle"]))
def test_every_tolerance_that_the_promise_allows_is_right(kata):
    problem = find_problem(kata)
    source = (SOLUTIONS / kata / "accepted" / "tolerant.py").read_text(encoding="utf-8")
    assert COMPARED.search(source)
    for seed in (None, 31):
        data = load_data(problem, seed=seed)
        for tolerance in ("1e-12", "1e-8", "5e-8", "1e-5"):
            changed = COMPARED.sub(f"{tolerance} * ", source).encode()
            verdict = judge_submission(data, changed, "mine.py", Settings(measured=False)).result.verdict
            assert verdict is (Verdict.WA if tolerance == "1e-5" else Verdict.AC), (tolerance, seed)
