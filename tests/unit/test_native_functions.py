"""Functions in other languages, called through drivers: every type, and every way to end a call."""

from __future__ import annotations

from array import array

import pytest
from native import LIMITS, answers, box_of, called, signature, sources
from sampling import daily

from judge.sandbox import Stop
from judge.sandbox.calls import replies, text

pytestmark = pytest.mark.slow

REAL = signature("real", x="real")
FOUR = {"x": "real", "A": "point", "n": "int", "w": "word(left|right|throw|leave)"}
POINTS = signature("[vec2; 0..2]", **FOUR)  # all that there is in C
ALL = signature(
    "(real, [int], [vec2; 0..2], enclosure)?", **FOUR, items="[point; 0..9]", more="int?", raw="array(f64)"
)
# Each prints what an answer looks like, has a main of its own, and fails when told to throw or to leave.
EVERYTHING = sources("everything")
LEFT = {"a.c": "SIGABRT", "a.cpp": "SIGSEGV", "a.go": "mid-call", "Any.java": "status 3"}
LEFT |= {"a.rs": "status 4", "a.js": "mid-call", "a.pypy": "status 5"}


def wanted(x, a, n, w, items, more, raw):
    third = [[x * a[1], a[0] if w == "left" else -a[0]]] * n
    second = [int(v) + (more or 0) for v in raw] + [int(q[0]) for q in items]
    return None if more is None else [-x, second, third, [-x, x]]


def row(x=1.0, a=(1.5, 1), n=1, w="left", items=(), more=4, raw=()):
    return x, a, n, w, list(items), more, array("d", raw)


ROWS = [row(x) for x in (0.1, 1e-308, 1.7976931348623157e308, 5e-324, 12345678901234.5, 3, -2.5)]
ROWS += [
    row(2.0, (1.5, 4), 2, items=[(1.5, 2.0), (2.0, 3.0)], raw=[1.0, 2.0]),
    row(1, (1.25, 8.0), 1, "right", more=-1),
    row(n=0, raw=[7]),
    row(items=[(1.0, 1.0)], more=None),
]
FAILING = [row(), row(w="throw"), row(2.0)]
LEAVING = [row(), row(w="leave"), row(2.0)]


class Everything:
    """A language's program that is compiled once, called with as much of a row as the language takes."""

    def __init__(self, name, box):
        self.name, self.box, self.is_c = name, box, name == "a.c"

    def given(self, rows):
        return [each[:4] if self.is_c else each for each in rows]

    def wanted(self, rows):
        return [wanted(*each[:4], [], 0, [])[2] if self.is_c else wanted(*each) for each in rows]

    def replies(self, rows):
        return self.box.call_many("mirror_all", self.given(rows), LIMITS).replies


@pytest.fixture(scope="module", params=EVERYTHING)
def everything(request):
    name = request.param
    with box_of(name, EVERYTHING[name], signature=POINTS if name == "a.c" else ALL) as box:
        assert box.inspect().fault is None, box.inspect().fault
        yield Everything(name, box)


def test_every_type_passes_unchanged_whatever_is_printed(everything):
    assert [reply.answer for reply in everything.replies(ROWS)] == everything.wanted(ROWS)


def test_what_is_raised_costs_its_own_call(everything):
    if everything.is_c:
        pytest.skip("C raises nothing")
    found = everything.replies(FAILING)
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.EXCEPTION, Stop.ANSWERED]
    assert "two" in found[1].detail


def test_the_call_that_ends_the_process_is_the_one_to_blame(everything):
    found = everything.replies(LEAVING)
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.EXITED]
    assert LEFT[everything.name] in found[1].detail


def test_a_call_without_end_is_the_one_to_blame():
    source = 'double mirror_all(double x) { while (x == 2) { __asm__(""); } return x; }'
    found = called("a.c", source, REAL, [(1.0,), (2.0,), (3.0,)], cpu_seconds=0.3)
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.CPU]


# -- integers of any length --------------------------------------------------------------------------------

BIG = signature("int", n="int")._replace(big=True)
NEGATED = sources("negated")


@pytest.mark.parametrize("name", daily(NEGATED, ["a.js", "a.go"]))
def test_integers_of_any_length_where_the_language_has_them(name):
    assert answers(name, NEGATED[name], BIG, [(10**40,), (7,)]) == [{"int": f"{-(10**40):x}"}, -7]


def test_a_function_may_take_them_as_numbers_of_the_machine_while_they_fit():
    source = "long long mirror_all(long long n) { return n / -2; }"
    calls = [(2**63 - 1,), (-(2**63),), (2**63,), (7,)]
    found = called("a.cpp", source, BIG, calls)
    assert [reply.answer for reply in found] == [-(2**62 - 1), 2**62, None, -3]
    assert found[2].detail == f"{2**63} does not fit into long long"


# -- what goes between --------------------------------------------------------------------------------------


def test_answers_are_foreign_data():
    assert replies(b'[0,1]\n[0,[1,"a"]]\n[0', 3)[0] == replies(b'[0,1]\n[0,[1,"a"]]\n', 3)[0]
    assert replies(b"[0,1]\n[0,2]\n", 1)[1] is False
    assert replies(b"hello\n", 1) == ([], False)
    assert replies(b"[2,1]\n", 1) == ([], False)


def test_arguments_are_written_as_tokens():
    assert text([(1, 0.1, (2, "left"), [(1, 2)], None)]) == b"1 0\n1 0.1 2 left 1 1 2 none\n"
    assert text([([], [0.5, 3], array("d", [1, 2.5]), [[1], []])]) == b"1 0\n0 2 0.5 3 2 1.0 2.5 2 1 1 0\n"


def test_answers_are_in_the_form_that_python_sends():
    big = 1 << 63
    lines = f'[0,[1,2]]\n[0,[{big - 1},{-big}]]\n[0,[{big},1]]\n[0,[0.5,1]]\n[0,[{-big - 1},0.5,"a",[]]]\n'
    found, _ = replies(lines.encode(), 5)
    assert [each.answer for each in found] == [
        [1, 2],
        [big - 1, -big],
        [{"int": f"{big:x}"}, 1],
        [0.5, 1],
        [{"int": f"{-big - 1:x}"}, 0.5, {"word": "a"}, []],
    ]
