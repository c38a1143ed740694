"""The signs by which a file tells its problem, and what they fit."""

from __future__ import annotations

import pytest

from judge.problem.find import fitting_problems, meant_problem, signs


@pytest.mark.parametrize(
    ("source", "defined", "nested"),
    [
        ("def one(a):\n    def two(): pass\n", {"one"}, {"two"}),
        ("class Solution:\n    def one(self): pass\n", {"Solution"}, {"one"}),
        ('"""\ndef one(): pass\n"""\n# x\n#def two(): pass\ndef three(): pass\n', {"three"}, set()),
        ("s = 'it\\'s'\nt = \"'''\"\ndef one(): pass\n", {"s", "t", "one"}, set()),
        ('def one(): pass\n"""never closed\ndef two(): pass\n', {"one"}, set()),
        ("def one():\r\n    pass\r\ndef two():\r\n    pass\r\n", {"one", "two"}, set()),
    ],
)
def test_what_a_text_defines(source, defined, nested):
    found = signs(source.encode(), "x.py")
    assert (found.defined, found.nested) == (frozenset(defined), frozenset(nested))


@pytest.mark.parametrize(
    ("source", "name", "stub", "stem"),
    [
        ('"""count: how many.\n"""\n', "a/ray_nearest.py", "count", "ray-nearest"),
        ("# by me\n\n'''exact-count: x'''\n", "Count.py", "exact-count", "count"),
        ("x = '''count: x'''\n", "x", "", "x"),
        ('"""Notes: x"""\n', "x.py", "", "x"),
    ],
)
def test_what_a_stub_and_a_name_say(source, name, stub, stem):
    found = signs(source.encode(), name)
    assert found.hints == (stub, stem)


@pytest.mark.parametrize(
    ("source", "name", "wanted"),
    [
        ("def circle_segment(a): pass\n", "count.py", ["segment"]),  # what it defines says most
        ("def line_count(a): pass\ndef exact_count(a): pass\n", "x.py", ["count", "exact-count"]),
        ("def line_count(a): pass\ndef exact_count(a): pass\n", "exact_count.py", ["exact-count"]),
        ('"""count: x"""\ndef line_count(a): pass\ndef exact_count(a): pass\n', "exact_count.py", ["count"]),
        ("print(input())\n", "ray-nearest.py", ["ray-nearest"]),
        ("class A:\n    def line_count(self): pass\n", "x.py", ["count"]),
        ("print(1)\n", "x.py", []),
        ("class A { static int lineCount(double cx) { return 1; } }", "Main.java", ["count"]),
        ("// segment: Circle and segment.\nfn main() {}\n", "x.rs", ["segment"]),
        ("int main() {}\n", "ray_nearest.c", ["ray-nearest"]),
    ],
)
def test_the_problem_that_fits(source, name, wanted, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    fitting = fitting_problems(signs(source.encode(), name))
    assert sorted(problem.id for problem in fitting) == wanted


def test_the_nearest_entry_is_meant():
    assert meant_problem(signs(b"def linecount(a): pass\n", "x.py")) == ("linecount", "line_count", "count")
    assert meant_problem(signs(b"def quite_different(a): pass\n", "x.py")) is None


@pytest.mark.parametrize("piece", ['"""', "'", '\\"""', "import a" + ".b" * 50, "#", "f(" * 90, "\n"])
def test_a_text_made_to_keep_the_judge_busy_is_read_like_any_other(piece):
    found = signs(piece.encode() * 50_000 + b"\ndef one(): pass\n", "x.py")
    assert found.hints[1] == "x"
