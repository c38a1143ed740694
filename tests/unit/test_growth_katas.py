"""The katas of many circles: naive loops are too slow by how they grow.

That the rule is told with each group is in the record: transcripts/why/growth.txt.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from judge.data import load_data
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.report.problems import detail_lines
from judge.run.execute import run_submission
from judge.run.result import Mode

ROOT = Path(__file__).parents[2]
GROWS = re.compile(r"it grows like n\^(\d\.\d), the reference like n\^(\d\.\d)")
SIZES = {"n-500", "n-2000"}
PROGRAM = """
import sys
from math import inf, sqrt

def main():
    numbers = iter(map(int, sys.stdin.read().split()))
    for _ in range(next(numbers)):
        circles = [(next(numbers), next(numbers), next(numbers)) for _ in range(next(numbers))]
        ox, oy = next(numbers), next(numbers)
        beams = [(next(numbers), next(numbers)) for _ in range(next(numbers))]
        said = [str(len(beams))]
        for dx, dy in beams:
            a, best, found = dx * dx + dy * dy, inf, None
            for i, (x, y, r) in enumerate(circles):
                fx, fy = x - ox, y - oy
                b = dx * fx + dy * fy
                if b > 0:
                    q = r * r * a - (dx * fy - dy * fx) ** 2
                    if q >= 0 and b - sqrt(q) < best:
                        best, found = b - sqrt(q), i
            said.append("none" if found is None else f"{found} {best / a!r}")
        print(*said)

main()
"""


@pytest.fixture(scope="module")
def judged(tmp_path_factory):
    """Judges a program by nothing but its growth, on cases of the two small sizes."""
    folder = tmp_path_factory.mktemp("growth")

    def judge(name, source):
        problem = folder / "problems" / name
        if not problem.exists():
            shutil.copytree(ROOT / "problems" / name, problem)
            shutil.copytree(ROOT / "solutions" / name, folder / "solutions" / name)
            (problem / "hashes.json").unlink()
            text = (problem / "problem.toml").read_text(encoding="utf-8")
            text = re.sub(r"\[groups\.time\]\nlimit = \d+\n", "[groups.time]\nlimit = 10000\n", text)
            text = re.sub(
                r"cpu_seconds = \d+(\nwall_seconds = \d+)?", "cpu_seconds = 60\nwall_seconds = 600", text
            )
            text = re.sub(r"(seed = 7[12]10\ncount =) \d+", r"\1 20", text)  # to count on a quick machine too
            text = text[: text.index('[[groups]]\nname = "n-8000"')].replace(', "n-8000", "n-32000"', "")
            left = 100 - sum(map(int, re.findall(r"^points = (\d+)", text, re.MULTILINE)))
            text = text.replace("points = 0\n", f"points = {left}\n", 1)
            (problem / "problem.toml").write_text(text, encoding="utf-8")
        loaded = load_problem(problem)
        data = load_data(loaded, cache=False)
        return run_submission(loaded, data, source, "naive.py", groups=SIZES)

    return judge


def check_too_steep(result):
    assert result.verdict is Verdict.TLE
    growth = result.time.growth
    assert set(growth.groups) == SIZES
    assert growth.exponent > growth.reference + growth.slope
    assert GROWS.search(result.failure.message)
    assert "its exponent may exceed that by 0.4" in result.failure.message  # and no other limit struck


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["nearest", "beams"])
def test_the_naive_loop_is_too_slow_by_how_it_grows(name, judged):
    check_too_steep(judged(name, (ROOT / "solutions" / name / "slow" / "quadratic.py").read_bytes()))


@pytest.mark.nightly
def test_so_is_a_naive_program(judged):
    result = judged("beams", PROGRAM.encode())
    assert result.mode is Mode.PROGRAM
    check_too_steep(result)


def test_a_kata_is_shown_with_its_rule():
    lines = ["".join(span.text for span in each) for each in detail_lines(find_problem("nearest"), None)]
    rule = "at most n^0.4 faster than the reference, over n-500, n-2000, n-8000, n-32000"
    assert f"growth      {rule}" in [line.strip() for line in lines]
