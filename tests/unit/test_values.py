"""The types of answers: what is accepted, what is told of the rest, by composition."""

from __future__ import annotations

import json
import pickle
from array import array
from fractions import Fraction
from pathlib import Path

import pytest

from judge.data.build import bounds_fault
from judge.errors import ProblemError
from judge.exact import Surd
from judge.problem import Parameter
from judge.sandbox.encode import encode
from judge.values import check, parameters, reading, show, wire
from judge.values.answers import AnyOf, Judged, Real, Tolerance, Words, vector
from judge.values.atoms import Atom
from judge.values.check import Accepted, Rejection, is_right
from judge.values.grammar import TypeFault, parse

TOLERANCE = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
HITS = "[(real, int, word(enter|touch|exit))]"
HIT = (Real(Surd(1), 1), 0, "enter")
EXIT, TOUCH = (Real(Surd(2), 1), 0, "exit"), (Real(Surd(2), 1), 1, "touch")
TIED = AnyOf([[HIT, EXIT, TOUCH], [HIT, TOUCH, EXIT]])  # the last two in any order


def word(text):
    return {"word": text}


def sent(code, items):
    return {"array": [code, array(code, items).tobytes().hex()]}


def judged(text, exact, raw, words=None):
    type_ = parse(text, words=words or Words())
    target = check.target(type_, exact, TOLERANCE)
    outcome = check.check(type_, raw, target, lambda: (exact, TOLERANCE))
    assert is_right(type_, raw, target, lambda: (exact, TOLERANCE)) == isinstance(outcome, Accepted)
    return outcome


def printed(text, exact, line):
    type_ = parse(text)
    return check.check_line(type_, line, check.target(type_, exact, TOLERANCE), lambda: (exact, TOLERANCE))


RIGHT = [  # what a perfect function gives in any type is drawn in tests/property
    ("int", 10**30, {"int": f"{10**30:x}"}),
    ("real", Real(Surd(0, 1, 2), 1), 2**0.5),
    ("vec3", vector((1, 2, Fraction(1, 2)), 1), [1, 2.0, {"fraction": ["1", "2"]}]),
    ("[vec2; 0..2]", [vector((1, 2), 1)], {"tuple": [[1.0, 2.0]]}),
    (HITS, TIED, [[1.0, 0, word("enter")], [2.0, 1, word("touch")], [2.0, 0, word("exit")]]),
    (HITS, TIED, [[1.0, 0, word("enter")], [2.0, 0, word("exit")], [2.0, 1, word("touch")]]),
    ("int", AnyOf([1, 2]), 2),
    ("(int, real)?", AnyOf([(1, Real(2, 1)), (3, Real(2, 1))]), [3, 2.0]),
    ("[int]", [AnyOf([1, 2]), 3], [2, 3]),
    ("[vec2]", [AnyOf([vector((1, 2), 1), vector((3, 4), 1)])], [[3.0, 4.0]]),
    ("word(run|any)", "run", word("run")),
    ("[int]", [0, 1, 2], sent("b", [0, 1, 2])),
    ("[int]", [0, 1, 2], sent("q", [0, 1, 2])),
    ("[real]", [Real(Surd(0, 1, 2), 1)], sent("d", [2**0.5])),
    ("[int]", [1, 2], sent("q", [1, 2])),
]


@pytest.mark.parametrize(("text", "exact", "raw"), RIGHT)
def test_right_answers_in_other_forms(text, exact, raw):
    assert isinstance(judged(text, exact, raw), Accepted)


WRONG = [
    ("int", 3, 4, "3 expected, 4 given"),
    ("int", 3, {"type": "generator", "text": ""}, "a generator where an int is expected"),
    ("int", 3, {"tuple": [3]}, "the tuple (3,) where an int is expected"),
    ("real", Real(1), 2.0, "the answer is off by 1, relative error 1"),
    ("real?", Real(1), None, "1.0 expected, None given"),
    ("real", Real(1), {"type": "float", "text": "nan"}, "it is not a finite number"),
    ("word(lit|dark)", "lit", word("dark"), "'lit' expected, 'dark' given"),
    ("word(lit|dark)", "lit", 1, "1 where lit or dark is expected"),
    ("vec2", vector((1, 2)), [1.0, 3.0], "y is off by 1, relative error 0.5"),
    ("vec2", vector((1, 2)), {"type": "complex", "text": "2j"}, "the complex 2j where (x, y) is expected"),
    (
        "vec3",
        vector((1, 2, 3)),
        {"type": "complex", "text": "1j"},
        "the complex 1j where (x, y, z) is expected",
    ),
    ("word(lit|dark)", "lit", word("Lit"), "'Lit' where lit or dark is expected"),
    ("vec3", vector((1, 2, 3)), [1.0, 2.0], "the answer has 2 coordinates where (x, y, z) is expected"),
    ("(int, real)", (1, Real(2)), [2, 2.0], "part 1: 1 expected, 2 given"),
    ("[int]", [1, 2], [1], "2 items expected, 1 given"),
    ("[int]", [1, 2], [2, 1], "the right items in the wrong order"),
    ("[int]", [1, 0, 1, 0], [1, 1, 0, 0], "item 2: 0 expected, 1 given"),
    ("[int]", [1, 2], [1, 3], "item 2: 2 expected, 3 given"),
    ("[int]", [1, 2], None, "None where a list of ints is expected: no items are []"),
    ("[int; 2]", [1, 2], [1, 2, 3], "the answer has 3 items where 2 are expected"),
    ("[int]", [1], {"type": "set", "text": ""}, "a set has no order"),
    ("[int]", [1], {"type": "generator", "text": ""}, "wrap it in list(...)"),
    ("[vec2]", [vector((1, 2))], [1.0, 2.0], "(1.0, 2.0) where a list of points is expected"),
    ("[(vec2, int)]", [(vector((1, 2)), 0)], [[[1.0, 9.0], 0]], "y of part 1 of item 1 is off by 7"),
    (HITS, [HIT], [[1.0, 0, word("exit")]], "part 3 of item 1: 'enter' expected, 'exit' given"),
    (HITS, [HIT], [[1.0, 0]], "item 1 has 2 parts where a tuple[float, int, str] is expected"),
    (
        HITS,
        AnyOf([[EXIT, TOUCH], [TOUCH, EXIT]]),
        [[2.0, 0, word("exit")]] * 2,
        "part 2 of item 2: 1 expected, 0 given",
    ),
    (
        HITS,
        TIED,
        [[1.0, 0, word("enter")], [2.0, 1, word("touch")], [2.0, 1, word("exit")]],
        "part 2 of item 3: 0 expected, 1 given",
    ),
    ("[int]", AnyOf([[1, 2, 3, 4], [2, 1, 3, 4]]), [2, 1, 3, 5], "item 4: 4 expected, 5 given"),
    ("[int]", AnyOf([[1, 2, 3], [2, 1, 3]]), [3, 1, 2], "the right items in the wrong order"),
    ("int", AnyOf([1, 2]), 3, "1 or 2 expected, 3 given"),
    ("(int, int?)", (7, AnyOf([1, 2])), [7, 3], "part 2: 1 or 2 expected, 3 given"),
    ("int?", AnyOf([1, 2]), None, "1 or 2 expected, None given"),
    ("real", AnyOf([Real(1), Real(4)]), 3.5, "the answer is off by 0.5"),
    ("[int]", [0, 1], sent("b", [0, 2]), "item 2: 1 expected, 2 given"),
    ("[int]", [0, 1], sent("d", [0, 1]), "the float 0.0 where item 1 is expected as an int"),
    ("[real]", [Real(1)], sent("d", [2.0]), "item 1 is off by 1"),
    ("word(run|any)", "any", word("run"), "'any' expected, 'run' given"),
]


NO_LISTS = [
    {"type": "bool", "text": "False"},
    {"type": "set", "text": "set()"},
    {"word": ""},
    {"fraction": ["0", "1"]},
    {"array": ["d", "zz"]},
    {},
    None,
    0,
]


@pytest.mark.parametrize("raw", NO_LISTS, ids=str)
@pytest.mark.parametrize("text", ["[int]", "[real]", "[vec2]", HITS, "[int; 0..4]"])
def test_what_is_no_list_is_no_empty_list(text, raw):
    assert isinstance(judged(text, [], raw), Rejection)


@pytest.mark.parametrize(("text", "exact", "raw", "message"), WRONG)
def test_wrong_answers_say_why(text, exact, raw, message):
    outcome = judged(text, exact, raw)
    assert isinstance(outcome, Rejection)
    assert message in outcome.message


class Text(Atom):
    """A type of a pack's own, of any text."""

    text, noun = "text", "a text"

    def why_not(self, value):
        return None if type(value) is str else "not a text"

    def value_of(self, raw):
        if (found := wire.word(raw)) is None:
            raise ValueError("no text")
        return found

    def sent(self, value):
        return {"word": value}


LETTERS = [each * times for each in ("a", "é") for times in (32, 33, 81, wire.LONGEST_TEXT)]


@pytest.mark.parametrize("right", [*LETTERS, "a\n" * 100], ids=len)
def test_a_text_is_compared_whole_and_shown_cut(right):
    target = check.target(Text(), right, None)
    for given in (right, f"{right[:-1]}b", right[:-1], f"{right}b", right[:80]):
        outcome = check.check(Text(), json.loads(json.dumps(encode(given))), target, None)
        assert isinstance(outcome, Accepted) is (given == right)
        assert given == right or len(outcome.message) + len(outcome.got) + len(outcome.wanted) < 1000
        if given.isascii() and given.isprintable():
            assert isinstance(check.check_line(Text(), given, target, None), Accepted) is (given == right)


def test_an_answer_that_no_submission_could_send_is_the_setters_fault():
    with pytest.raises(ProblemError, match="a text of 1,000,001 characters, where 1,000,000 may be sent"):
        check.target(Text(), "a" * (wire.LONGEST_TEXT + 1), None)


def test_a_wrapper_is_no_word_of_that_name():
    """The names of the wrappers in a target are never taken for an answer."""
    exact = AnyOf([[("run", 1), ("any", 2)], [("any", 2), ("run", 1)]])
    for raw in ([word("any")], [[word("run"), 1]], [[word("any"), 2], [word("any"), 2]], {"any": [1]}):
        assert isinstance(judged("[(word(run|any), int)]", exact, raw), Rejection)


def test_a_problem_has_its_own_words():
    words = Words(answer="t", missing="but there is one", order="they come upwards", negative="never is it")
    assert judged("real?", Real(1), None, words).message == "None given, but there is one: t = 1.0"
    for below in (-1, -1.0, {"decimal": "-1.5"}, {"int": str(-(10**99))}, {"fraction": ["-1", "3"]}):
        assert judged("real?", Real(1), below, words).message == "t is negative: never is it"
    assert "t is off by 0.5" in judged("real?", Real(1), {"decimal": "1.5"}, words).message
    assert "negative" not in judged("real?", Real(-1), -2.0, words).message
    off = judged("real?", Real(1), 2.0, words)
    assert (off.where, off.message[:10]) == ("t", "t is off b")
    order = judged("[int]", [1, 2], [2, 1], words)
    assert order.message == "the right items in the wrong order: they come upwards"
    assert reading.read_line(parse("int?", words=Words(meant="0 or 1")), "x") == (
        '"x" where 0 or 1 is expected: write a plain integer'
    )


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("int?", "1.5", '"1.5" where an int or none is expected: write a plain integer'),
        ("real?", "None", '"None" where a number or none is expected: write none in lower case'),
        ("word(lit|dark)", "lit dark", '"dark" after the answer: one line holds lit or dark'),
        ("[vec2; 0..2]", "3 1 1 1 1 1 1", "k = 3 where 0 to 2 points are expected"),
        ("[vec2; 0..2]", "1 1 x", '"x" where a coordinate is expected: it is not a plain decimal number'),
        ("([int], int)", "5 1 2", "the line ends too early"),
        ("([int], int)", "1 1 2 3", '"3" after the answer'),
        (HITS, "-1", "k = -1 where 0 or more items are expected"),
    ],
)
def test_lines_that_hold_no_answer(text, line, message):
    answer = reading.read_line(parse(text), line)
    assert isinstance(answer, str)
    assert message in answer


def test_lines_of_nested_answers():
    type_ = parse(HITS)
    target = check.target(type_, TIED, TOLERANCE)
    assert show.line(type_, target) == "3 1.0 0 enter 2.0 0 exit 2.0 1 touch"
    assert isinstance(printed(HITS, TIED, "3 1 0 enter 2 1 touch 2 0 exit"), Accepted)


@pytest.mark.parametrize(
    ("text", "exact", "why"),
    [
        ("int", 1.0, "1.0, a float, where an int is expected"),
        (
            "real",
            Real(0.1, 1),
            "Real(x=0.1, unit=1) holds a float; write Fraction(x) where a double is the exact number",
        ),
        ("[vec2; 0..2]", [vector((1, 2))] * 3, "3 points where 0 to 2 are expected"),
        ("(int, int)", (1, 2, 3), "3 parts where a tuple[int, int] is expected"),
        ("int", AnyOf([]), "AnyOf without answers"),
    ],
)
def test_an_exact_answer_of_another_type_is_the_setters_fault(text, exact, why):
    with pytest.raises(ProblemError) as raised:
        check.target(parse(text), exact, TOLERANCE)
    assert raised.value.what == f"the exact answer is no {text}: {why}"


@pytest.mark.parametrize(
    ("text", "what", "remedy"),
    [
        ("complex", "'complex' is unknown", "use one of count, points"),
        ("interger", "'interger' is unknown", "did you mean 'integer'?"),
        ("[str]", "'[str]' is not a type: 'str' is unknown", "did you mean 'text(low..high)'?"),
        ("boolean", "'boolean' is unknown", "did you mean 'bool'?"),
        ("txt(0..60)", "'txt(0..60)' is not a type: 'txt' is unknown", "did you mean 'text(0..60)'?"),
        ("[itn(-1..9); 3]", "'itn' is unknown", "did you mean 'int(-1..9)'?"),
        ("wrod(a|b)", "'wrod' is unknown", "did you mean 'word'?"),
        ("enum", "'enum' is unknown", "did you mean 'word(a|b)'?"),
        ("text(9..3)", "'text(9..3)' is not a type: low is above high", "write text(low..high)"),
        ("[int(9..3)]", "'[int(9..3)]' is not a type: low is above high", "write int(low..high)"),
        ("text(0..2000000)", "a text has at most 1,000,000 characters", ""),
        ("text(-1..3)", "no text has fewer than 0 characters", ""),
        ("int(5)", "'int(5)' is not a type", "give both bounds, int(low..high)"),
        ("real(1..x)", "'x' is not a whole number", ""),
        ("bool(1)", "there are too many or too few words", ""),
        ("[int", "'[int' is not a type: its end where ']' is expected", "[T; low..high]"),
        ("(int)", "a tuple has two parts or more", ""),
        ("[int; 3..2]", "low is above high", ""),
        ("int??", "'?' comes after its end", ""),
        ("(int?, int)?", "whether all of it is none or only its first part", ""),
        ("word(a)", "a word is one of two or more", ""),
        ("array(i8)", "an array holds f64", ""),
        ("[array(f64)]", "an array is a whole parameter", ""),
        ("[" * 40 + "int", "it is nested too deep", ""),
        ("int€", "'€' belongs in no type", ""),
    ],
)
def test_texts_that_are_no_types(text, what, remedy):
    with pytest.raises(TypeFault) as raised:
        parse(text)
    assert what in raised.value.what
    assert remedy in raised.value.remedy


@pytest.mark.parametrize(
    "text", ["count", "[vec2; 0..2]", HITS, "array(f64; 1000)", "(int, [int; 3])?", "integer-point"]
)
def test_a_type_is_its_text(text):
    type_ = parse(text)
    assert str(type_) == text
    assert pickle.loads(pickle.dumps(type_)) == type_
    assert type_ != parse("real")
    assert len({type_, parse(text)}) == 1


def test_a_radius_is_never_negative():
    folder = Path(__file__).parents[2] / "problems" / "types"
    circle, inside = parse("circle", folder), (1, 2, 0)

    def beyond(type_, value):
        class Known:
            parameters = (Parameter("c", type_, "", Fraction(-5), Fraction(5)),)

        return bounds_fault(Known, (value,))

    assert beyond(circle, inside) is None
    assert beyond(circle, (1, 2, -1)) == "c has -1, outside 0 to 5"
    several = parse("[integer-circle]", folder)
    assert beyond(several, (inside, (1, -9, 1))) == "c has -9, outside -5 to 5"
    wrong = parameters.fault(circle, "c", (1, 2))
    assert wrong == "c has 2 parts where a tuple[float, float, float] is expected"
    wrong = parameters.fault(parse("integer-circle", folder), "c", (1, 2, 3.0))
    assert wrong == "c has 3.0, a float, where an int is expected"


@pytest.mark.parametrize(
    ("line", "value"),
    [("12", 12), ("0.5", 0.5), ("1e400", Fraction(10**400)), ("-1e400", -Fraction(10**400))],
)
def test_what_a_problem_decides_itself_is_finite(line, value):
    handed = []
    printed("real", Judged(lambda number, _group: handed.append(number), Real(1)), line)
    assert handed == [value]
