"""Groups whose integers are wider than a language has: who is judged on them, and what is said of it."""

from __future__ import annotations

import json

import pytest

from judge.data.load import load_data
from judge.languages import find
from judge.languages.model import language_called
from judge.problem.find import find_problem

pytestmark = pytest.mark.slow

READ = """
#include <iostream>
#include <string>
typedef __int128 Int;
static Int get() {
    std::string s; std::cin >> s;
    bool minus = s[0] == '-'; Int v = 0;
    for (char c : s) if (c != '-') v = v * 10 + (c - '0');
    return minus ? -v : v;
}
int main() {
    int t; std::cin >> t;
    while (t--) {
        Int cx = get(), cy = get(), r = get(), ax = get(), ay = get(), bx = get(), by = get();
        Int dx = bx - ax, dy = by - ay, fx = ax - cx, fy = ay - cy, a = dx * dx + dy * dy;
        if (a == 0) { std::cout << "none\\n"; continue; }
        Int k = dx * fy - dy * fx, d = r * r * a - k * k;
        std::cout << ANSWER << "\\n";
    }
}
"""
RIGHT = READ.replace("ANSWER", "(d < 0 ? 0 : d == 0 ? 1 : 2)")
WRONG = READ.replace("ANSWER", "(d < 0 ? 0 : 2)")


def needed(cx, cy, r, a, b):
    """The bits of the widest integer of Δ' = r²|AB|² − k² on the way to it."""
    dx, dy, fx, fy = b[0] - a[0], b[1] - a[1], a[0] - cx, a[1] - cy
    k = dx * fy - dy * fx
    return max(each.bit_length() for each in (cx, cy, r, *a, *b, r * r * (dx * dx + dy * dy), k * k))


@pytest.mark.parametrize("name", ["exact-count", "exact-segment"])
def test_a_group_says_the_bits_that_its_cases_need(name):
    groups = load_data(find_problem(name)).groups
    for group in groups:
        most = max(needed(*case) for case in group.cases)
        assert most <= (group.group.bits or 64), group.group.name
        assert group.group.bits is None or most > 64, group.group.name
    assert any(group.group.bits and group.group.bits > 128 for group in groups)


@pytest.fixture
def cpp():
    language = language_called("cpp")
    if find.why_not(language):
        pytest.skip(f"no C++ here: {find.remedy(language)}")


def run(judge, tmp_path, source, *more):
    path = tmp_path / "mine.cpp"
    path.write_text(source)
    return judge("run", "exact-count", str(path), "--no-shrink", "--no-name", *more)


def test_a_program_in_the_integers_of_its_language_is_judged_on_what_fits(judge, tmp_path, cpp):
    ended = run(judge, tmp_path, RIGHT)
    assert ended.status == 0, ended
    assert "accepted, on 13 of 25 groups only" in " ".join(ended.out.split())
    assert "C++ has integers of 128 bits, and 12 groups need wider ones: not judged" in ended.err


def test_a_wrong_one_is_rejected_on_what_fits(judge, tmp_path, cpp):
    ended = run(judge, tmp_path, WRONG, "--json")
    assert ended.status == 1
    result = json.loads(ended.out)
    assert result["verdict"] == "WA"
    assert len(result["groups"]) == 13


def test_groups_that_are_asked_for_are_judged(judge, tmp_path, cpp):
    ended = run(judge, tmp_path, RIGHT, "--group", "wider")
    assert ended.status == 1


def test_who_brings_wider_integers_is_judged_on_all(judge, tmp_path, cpp):
    problem = find_problem("exact-count")
    source = (problem.solutions / "accepted" / "reference.cpp").read_text()
    ended = run(judge, tmp_path, source)
    assert ended.status == 0, ended
    assert "only" not in ended.out
    assert "not judged" not in ended.err
