"""Texts, truth values and bounds in a type: read, compared, told, drawn, and made smaller."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import msgspec
import pytest

from judge import judge
from judge.cache import DISK
from judge.data.load import load_data
from judge.data.parse import line_of, read_case
from judge.diagnose.candidates import measure
from judge.diagnose.replay import decode, encode
from judge.errors import ProblemError, UsageError
from judge.holes.hunt import look_for_holes
from judge.holes.model import HoleSearch
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.run.result import short_answer
from judge.sandbox import Containment
from judge.sandbox.available import levels_here
from judge.sandbox.encode import encode as sent
from judge.values import check, parameters
from judge.values.answers import AnyOf, Judged, Real, Tolerance
from judge.values.check import Accepted, Rejection
from judge.values.grammar import TypeFault, parse
from judge.values.letters import expanded
from judge.verify.gate import Options, verify_problem

KATAS = Path(__file__).parents[2] / "judge" / "manual" / "katas"
OWN = ("brackets", "runs")
HELD = any(each.available for each in levels_here() if each.name != "limits")
A40 = "a" * 40


def told(text, exact, given, *, line=False):
    """Why that answer is wrong; empty for a right one. It is given as a function returns it, or as a line."""
    type_ = parse(text)
    target = check.target(type_, exact, Tolerance())
    raw = given if line else json.loads(json.dumps(sent(given)))
    found = (check.check_line if line else check.check)(type_, raw, target, lambda: (exact, Tolerance()))
    assert isinstance(found, Accepted | Rejection)
    if isinstance(found, Accepted):
        return ""
    assert found.message.isprintable()
    assert len(found.message) + len(found.wanted) + len(found.got) < 2000
    return found.message


@pytest.mark.parametrize(
    ("text", "exact", "given", "why"),
    [
        ("text", "3a", "3b", "'3a' expected, '3b' given"),
        ("text", "3a", 3, "3 where a text is expected"),
        ("text", "a", None, "None where a text is expected"),
        ("text", "true", True, "the bool True where a text is expected"),
        ("text(2)", "ab", "abc", "a text of 3 characters where 2 are expected"),
        ("text(0..60)", "a", "a" * 61, "a text of 61 characters where 0 to 60 are expected"),
        ("text", "abc", "ab\xe9", r"'\xe9' at character 3: only ASCII letters and signs"),
        ("text", "abc", "a\0", r"'\x00' at character 2: only ASCII letters and signs"),
        ("text", "abc", "\ud800", r"'\ud800' at character 1: only ASCII letters and signs"),
        (
            "text",
            f"{A40}abc{A40}",
            f"{A40}abd{A40}",
            "at character 43: 'caaaaaaaaaaaaaaaaaaa'… expected, 'daa",
        ),
        ("text", A40 * 2, f"{A40 * 2}b", "at character 81: its end expected, 'b' given"),
        ("text", f"{A40 * 2}b", A40 * 2, "at character 81: 'b' expected, its end given"),
        ("text", "a", "a" * 3_000_000, "a text of 3,000,000 characters, more than 1,000,000, where"),
        ("text?", None, "none", "None expected, 'none' given"),
        ("[text]", ["a", "b c"], ["a", "b  c"], "item 2: 'b c' expected, 'b  c' given"),
        ("(text, int)", ("a", 1), ("b", 1), "part 1: 'a' expected, 'b' given"),
        ("text", AnyOf(["a", "b"]), "c", "'a' or 'b' expected, 'c' given"),
        ("bool", True, False, "True expected, False given"),
        ("bool", True, 1, "1 where a bool is expected"),
        ("bool", True, "True", "the str 'True' where a bool is expected"),
        ("bool?", None, False, "None expected, False given"),
        ("int", 1, True, "the bool True where an int is expected"),
        ("[bool]", [True, False], [True, 0], "0 where a bool is expected for item 2"),
        ("int(0..9)", 3, 12, "3 expected, 12 given"),
    ],
)
def test_what_is_told_of_a_wrong_answer(text, exact, given, why):
    assert told(text, exact, given).startswith(why)


@pytest.mark.parametrize(
    ("text", "exact", "given", "why"),
    [
        ("text", "a b", '"a b"', ""),
        ("text", "ab", '"ab"', ""),
        ("text", "ab", "ab", ""),
        ("text", "none", "none", ""),
        ("text", "a\"b'", "a\"b'", ""),
        ("text", "a\nb", r'"a\nb"', ""),
        ("text?", None, "none", ""),
        ("text?", "none", '"none"', ""),
        ("text?", "None", "None", ""),
        ("(text, text)", ("a b", ""), '"a b" ""', ""),
        ("[text]", ["a b", "c"], '2 "a b" c', ""),
        ("bool", True, "true", ""),
        ("text", "a b", "a b", '"b" after the answer: one line holds a text (in double quotes if it is'),
        ("text", "", "", "an empty line where a text (in double quotes if it is empty or has a blank) is"),
        ("text", "a", '"a', "'\"a' where a text (in double quotes"),
        ("text", "a", r'"\ud800"', r"'\ud800' at character 1"),
        ("text", "None b", '"None c"', "'None b' expected, 'None c' given"),
        ("text?", None, "None", "none expected, 'None' given"),
        ("bool", True, "True", '"True" where a bool is expected: write true or false'),
        ("bool", True, "1", '"1" where a bool is expected: write true or false'),
    ],
)
def test_what_is_told_of_a_programs_line(text, exact, given, why):
    found = told(text, exact, given, line=True)
    assert found.startswith(why)
    assert bool(found) is bool(why)


@pytest.mark.parametrize(
    ("text", "sample", "given", "why"),
    [
        ("int(0..9)", 1, 12, "12, outside 0 to 9"),
        ("[int(-5..5)]", [1], [3, -6], "-6, outside -5 to 5"),
        ("real(0..1)", Real(1), 1.5, "1.5, outside 0 to 1"),
        ("text(0..3)", "a", "abcd", "a text of 4 characters where 0 to 3 are expected"),
        ("text", "a", "\t", r"'\t' at character 1: only ASCII letters and signs"),
        ("word(a|b)", "a", "c", "'c' where a or b is expected"),
    ],
)
def test_a_checker_gets_only_what_the_type_lets_pass(text, sample, given, why):
    asked = []
    assert told(text, Judged(lambda value, _: asked.append(value), sample), given) == why
    assert asked == []


@pytest.mark.parametrize(
    ("text", "exact", "why"),
    [
        ("int(0..9)", 12, "12, outside 0 to 9"),
        ("real(0..1)", Real(2), "2, outside 0 to 1"),
        ("text(0..3)", "abcd", "a text of 4 characters where 0 to 3 are expected"),
        ("text", "\xfc", r"'\xfc' at character 1: only ASCII letters and signs"),
        ("bool", 1, "1 where a bool is expected"),
    ],
)
def test_an_exact_answer_beyond_its_type_is_the_setters_fault(text, exact, why):
    with pytest.raises(ProblemError) as raised:
        check.target(parse(text), exact, Tolerance())
    assert raised.value.what == f"the exact answer is no {text}: {why}"


def test_a_tolerance_may_reach_beyond_the_bounds():
    type_, exact = parse("real(0..1)"), Real(1)
    target = check.target(type_, exact, Tolerance(relative=1))
    assert isinstance(check.check(type_, 1.0000000000000002, target, lambda: (exact, None)), Accepted)


def test_half_of_a_surrogate_pair_is_in_no_result():
    assert short_answer({"word": "\ud800"}) is None
    assert short_answer({"word": "\xe9"}) == {"word": "\xe9"}


@pytest.mark.parametrize(
    ("letters", "meant"), [("a-e", "abcde"), ("ca-", "ca-"), ("-a", "-a"), ("0-2x-z", "012xyz")]
)
def test_letters_are_single_ones_and_ranges(letters, meant):
    assert expanded(letters) == meant


@pytest.mark.parametrize("name", ["text", "bool", "int"])
def test_a_type_of_the_judge_is_not_hidden_by_a_file(name, tmp_path):
    (tmp_path / f"{name}.py").write_text("TYPE = 'real'\n")
    with pytest.raises(TypeFault) as raised:
        parse(f"[{name}]", tmp_path)
    assert raised.value.what == f"types/{name}.py is not used: {name} is a type of the judge"
    assert raised.value.remedy == "rename or remove it"


# -- smaller ones ------------------------------------------------------------------------------------------


def smallest(text, value, fails, letters=""):
    """What steps of `simpler` lead to, each to the simplest value that still fails."""
    type_ = parse(text, letters=letters)
    while found := [
        each
        for each in parameters.simpler(type_, value)
        if measure((each,)) < measure((value,)) and fails(each)
    ]:
        value = min(found, key=lambda each: measure((each,)))
    return value


def test_a_text_is_shrunk_as_small_as_by_hand():
    assert smallest("text", "xy" + "q" * 14 + "z", lambda s: any(c * 10 in s for c in s)) == "a" * 10
    assert smallest("text", "[()]{})(", lambda s: ")(" in s or "}{" in s, "()[]{}") == ")("
    assert (
        smallest(
            "text",
            "abcxyx--hello",
            lambda s: any(a == c != b for a, b, c in zip(s, s[1:], s[2:], strict=False)),
        )
        == "aba"
    )
    assert smallest("text(3..9)", "pqrstuv", lambda s: True) == "aaa"
    assert (
        smallest("text", "a" * 33 + '""' + "b", lambda s: len(s) % 2 == 0 and "a" * 32 in s) == "a" * 32
    )  # at an odd place
    assert smallest("[text]", ("ab", "zz", "q"), lambda some: any(len(each) == 2 for each in some)) == ("aa",)
    assert smallest("(bool, bool)", (True, True), lambda pair: any(pair)) in ((True, False), (False, True))


# -- a kata of texts -----------------------------------------------------------------------------------------

TOML = """
title = "Echo"
tier = "junior"
summary = "The text again."
entry = "echo"
answer = "text"

[parameters]
s = { type = "text(0..9)", letters = "a-c", about = "a text" }
b = { type = "bool", about = "either" }
n = { type = "int(0..9)", about = "a digit" }
"""
STATEMENT = """# Echo

`s` has {{s.low}} to {{s.high}} of `{{s.letters}}`, n is up to {{n.high}}.

    >>> echo('ab', True, 3)
    'ab'
"""
MODULE = """
from judge.problem.declare import group

def solve(s, b, n):
    return s

def some(draw):
    return draw.choice("abc") * draw.integer(0, 5), draw.boolean(), draw.integer(0, 9)

GROUPS = [group("some", "Some.", some, cases=9)]
"""


@pytest.fixture
def made(tmp_path, monkeypatch):
    """Writes the kata, with some texts replaced in its files."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))

    def made(*edits):
        folder = tmp_path / "problems" / "echo"
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in (("problem.toml", TOML), ("statement.md", STATEMENT), ("problem.py", MODULE)):
            for old, new in edits:
                text = text.replace(old, new)
            (folder / name).write_text(text, encoding="utf-8")
        return folder

    return made


def test_a_kata_of_texts_is_read_and_kept(made):
    folder = made()
    first, again = load_problem(folder), load_problem(folder)
    assert again == first
    assert "`s` has 0 to 9 of `a-c`, n is up to 9." in first.statement
    assert [each.type.letters for each in again.parameters] == ["a-c", "", ""]
    assert load_problem(made(('letters = "a-c", ', ""))).parameters[0].type.letters == " -~"


@pytest.mark.parametrize(
    ("old", "new", "what", "remedy"),
    [
        ('answer = "text"', 'answer = "str"', "answer = 'str' is unknown", "did you mean 'text(low..high)'?"),
        ("text(0..9)", "text(9..3)", "type = 'text(9..3)' is not a type: low is above high", ""),
        ("int(0..9)", "int(5)", "type = 'int(5)' is not a type", "give both bounds, int(low..high)"),
        ('"int(0..9)"', '"int(0..9)", letters = "a"', "n has letters, and no text", "remove them"),
        ('"a-c"', '""', "letters is empty", "name at least one, or leave the key out"),
        (
            '"a-c"',
            '"c-a"',
            "letters = 'c-a': c-a is not a range: 'c' comes after 'a'",
            "single ones and ranges",
        ),
        ('"a-c"', '"\xfc"', r"letters = 'ü': '\xfc' is no ASCII letter or sign", ""),
        (
            'choice("abc")',
            'choice("\xfc")',
            r"group 'some' draws a case out of bounds: s has '\xfc', none of its letters 'a-c'",
            "draw others, or widen",
        ),
        (
            'choice("abc")',
            'choice("d")',
            "group 'some' draws a case out of bounds: s has 'd', none of its letters 'a-c'",
            "",
        ),
        ("draw.integer(0, 5)", "12", "s has a text of 12 characters where 0 to 9 are expected", ""),
        ("draw.integer(0, 9)", "11", "group 'some' draws a case out of bounds: n has 11, outside 0 to 9", ""),
        ("draw.boolean()", "1", "b has 1 where a bool is expected", ""),
        ("return s", "return b", "the exact answer is no text: True where a text is expected", ""),
        (
            "echo('ab', True, 3)",
            "echo('ab', 1, 3)",
            "the example is invalid: b has 1 where a bool is expected",
            "",
        ),
        (
            "echo('ab', True, 3)",
            "echo('ax', True, 3)",
            "the example is invalid: s has 'x', none of its letters 'a-c'",
            "",
        ),
        ("\n    'ab'", "\n    'ac'", "the example contradicts solve: 'ab' expected, 'ac' given", ""),
    ],
)
def test_a_setters_faults_of_types_are_told_in_a_line(made, old, new, what, remedy):
    folder = made((old, new))
    with pytest.raises(ProblemError) as raised:
        load_data(load_problem(folder), store=None)
    assert what in raised.value.what
    assert remedy in (raised.value.remedy or "")
    assert raised.value.where.startswith("echo/")


def test_bounds_of_a_type_and_of_the_parameter_hold_both(made):
    both = made(('type = "int(0..9)"', 'type = "int(0..9)", high = 7'), ("draw.integer(0, 9)", "8"))
    with pytest.raises(ProblemError, match="n has 8, outside 0 to 7"):
        load_data(load_problem(both), store=None)
    alone = made(
        ("int(0..9)", "int(0..9000000000)"), ("draw.integer(0, 9)", "draw.integer(8 * 10**9, 9 * 10**9)")
    )
    assert load_data(load_problem(alone), store=None).groups[1].cases[0][2] >= 8 * 10**9


@pytest.mark.parametrize("s", ["", "abc", "aab"])
def test_a_case_of_texts_is_read_in_every_form(made, s):
    problem = load_problem(made())
    case = s, False, 7
    assert read_case(problem, line_of(problem, case)) == case
    assert read_case(problem, f"{s!r}, False, 7") == case
    assert read_case(problem, f"s={s!r}, n=7, b=False") == case
    module, group = load_module(problem), problem.groups[1]
    assert decode(encode(problem, group, case), problem, module).case == case


@pytest.mark.parametrize(
    "text", ["abc", "abc true", "abc maybe 3", "'a', -True, 3", "a b, True", "((((", "'"]
)
def test_what_is_no_case_of_texts_is_told_in_a_line(made, text):
    with pytest.raises(UsageError) as raised:
        read_case(load_problem(made()), text)
    assert "\n" not in str(raised.value)


def test_an_id_holds_any_text_and_old_ids_are_read(made):
    problem = load_problem(made(('"a-c"', '"\\n -~"')))
    module, group = load_module(problem), problem.groups[1]
    for s in ("a,b", "%2C", ": :", "\n", '"', "none", "'\\", "+~"):
        replay = encode(problem, group, (s, True, 0))
        assert replay.isascii()
        assert not set(replay) & set(" \n\"'\\")
        assert decode(replay, problem, module).case == (s, True, 0)
    old = load_problem(Path(__file__).parents[2] / "problems" / "count")
    case = (0, 0.5, 1, (-1, 1e-07), (1, 1))
    check_digits = encode(old, old.groups[1], case).rpartition(":")[2]
    replay = f"count:grid:v0,0.5,1,-1,1e-07,1,1:{check_digits}"
    assert decode(replay, old, load_module(old)).case == case


# -- the templates ---------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", OWN)
def test_the_katas_to_begin_with_are_sound_on_three_sets_of_data(name):
    problem = load_problem(KATAS / "problems" / name)
    report = verify_problem(problem, Options(seeds=3, matrix=True))
    assert ([str(each) for each in (*report.faults, *report.warnings)], report.pins) == ([], "matching")
    made = {each.name for each in report.mistakes} - {"kept-between-calls"}
    assert len(made) >= 5
    files = ("problem.toml", "problem.py", "statement.md", "hints.md")
    assert sum(len((problem.folder / file).read_text("utf-8").splitlines()) for file in files) <= 75


RUNS = """from itertools import groupby
def runs(s):
    return "".join({} + c for c, g in groupby({}) for n in [len(list(g))])
"""
BALANCED = "def balanced(s):\n    return {}\n"


@pytest.mark.parametrize(
    ("name", "source", "case", "message"),
    [
        (
            "runs",
            RUNS.format("(str(n)[-1] if n > 1 else '')", "s"),
            "aaaaaaaaaa",
            "'10a' expected, '0a' given",
        ),
        ("runs", RUNS.format("(str(n) if n > 1 else '')", "s.strip()"), " ", "' ' expected, '' given"),
        (
            "brackets",
            BALANCED.format("all(s.count(a) == s.count(b) for a, b in ('()', '[]', '{}'))"),
            ")(",
            "False expected, True given",
        ),
        ("brackets", BALANCED.format("1"), "", "1 where a bool is expected"),
        (
            "runs",
            "class S(str): pass\ndef runs(s): return S(s)",
            "",
            "S, a subclass of str, where a text is expected",
        ),
        ("runs", "def runs(s): return '\\ud800' + s", "", r"'\ud800' at character 1"),
        ("runs", "def runs(s): return s.replace('b', '\\0')", "b", r"'\x00' at character 1"),
        (
            "runs",
            "def runs(s): return 'a' * 2_000_000",
            "",
            "a text of 2,000,000 characters, more than 1,000,000",
        ),
        ("runs", "def runs(s): return ['a' * 500_000] * 9", "", "a list where a text is expected"),
    ],
)
def test_the_smallest_case_of_a_wrong_submission(name, source, case, message):
    result = judge(load_problem(KATAS / "problems" / name), source)
    smallest = result.counterexample or result.failure
    assert result.verdict.value == "WA"
    assert smallest.input == {"s": case}
    assert message in smallest.message
    msgspec.json.encode(result.as_json())


@pytest.mark.slow
@pytest.mark.skipif(not HELD, reason="programs are changed only where they are contained")
def test_a_planted_hole_in_texts_is_found(tmp_path, monkeypatch):
    """Nothing draws a brace: programs that do not know them are accepted."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    shutil.copytree(KATAS, tmp_path / "katas")
    folder = tmp_path / "katas" / "problems" / "brackets"
    path = folder / "problem.py"
    text = path.read_text("utf-8")
    assert text.count("draw.choice(PAIRS)") == 2
    path.write_text(
        text.replace("draw.choice(PAIRS)", "draw.choice(PAIRS[:2])").replace('"()[]{}"', '"()[]"')
    )
    statement = folder / "statement.md"
    statement.write_text(statement.read_text("utf-8").replace("([]{})", "([])"))
    problem = load_problem(folder)
    data = load_data(problem, store=None)
    found = look_for_holes(problem, [data], Containment(), HoleSearch(seconds=1e9, cases=20_000), DISK)
    assert any("{" in hole.case and hole.kind == "text" for hole in found.holes)


# -- every form at once ------------------------------------------------------------------------------------

FORMS_TOML = """
title = "Forms"
tier = "junior"
summary = "Words in order, and the rest."
entry = "forms"
answer = "([text], bool, text?)"

[parameters]
words = { type = "[text(0..4); 0..3]", letters = "ab ", about = "words" }
flag = { type = "bool", about = "either" }
rest = { type = "text(0..3)?", letters = "x-z\\n", about = "a text, or None" }
"""
FORMS_STATEMENT = """# Forms

    >>> forms(['b', 'a b', ''], True, 'x\\ny')
    (['', 'a b', 'b'], True, 'x\\ny')
    >>> forms([], False, None)
    ([], False, None)
"""
FORMS_MODULE = """
from judge.problem.declare import group

def solve(words, flag, rest):
    return sorted(words), flag, rest

def text(draw, letters, most):
    return "".join(draw.choice(letters) for _ in range(draw.integer(0, most)))

def some(draw):
    words = tuple([text(draw, "ab ", 4) for _ in range(draw.integer(0, 3))])
    return words, draw.boolean(), text(draw, "xyz\\n", 3) if draw.boolean() else None

GROUPS = [group("some", "Some.", some)]
"""
PROGRAM = """
import json, re, sys
for line in sys.stdin.read().split(chr(10))[1:-1]:
    raw = re.findall(r'"(?:[^"\\\\]|\\\\.)*"|[^ ]+', line)
    found = [json.loads(each) if each[0] == '"' else each for each in raw]
    n = int(found[0])
    words, flag, rest = sorted(found[1 : n + 1]), found[n + 1], raw[n + 2]
    {}
    print(len(words), *map(json.dumps, words), flag, rest)
"""


@pytest.mark.parametrize(
    ("source", "name", "smallest", "message"),
    [
        ("def forms(words, flag, rest): return sorted(words), flag, rest", "a.py", None, ""),
        (
            "def forms(words, flag, rest): return sorted(filter(None, words)), flag, rest",
            "a.py",
            {"words": [""], "flag": False, "rest": None},
            "part 1: 1 item expected, none given",
        ),
        (
            "def forms(words, flag, rest): return sorted(words), flag or rest == 'z', rest",
            "a.py",
            {"words": [], "flag": False, "rest": "z"},
            "part 2: False expected, True given",
        ),
        (
            "def forms(words, flag, rest): return sorted(words), flag, rest or None",
            "a.py",
            {"words": [], "flag": False, "rest": ""},
            "part 3: '' expected, None given",
        ),
        (
            "def forms(words, flag, rest): return sorted(words), flag, rest and rest.replace('\\n', '')",
            "a.py",
            {"words": [], "flag": False, "rest": "\n"},
            r"part 3: '\n' expected, '' given",
        ),
        (PROGRAM.format(""), "program.py", None, ""),
        (
            PROGRAM.format("words = [each.strip() for each in words]"),
            "program.py",
            {"words": [" "], "flag": False, "rest": None},
            "item 1 of part 1: ' ' expected, '' given",
        ),
    ],
)
def test_texts_and_truth_values_in_every_form(tmp_path, monkeypatch, source, name, smallest, message):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    folder = tmp_path / "problems" / "forms"
    folder.mkdir(parents=True)
    (folder / "problem.toml").write_text(FORMS_TOML)
    (folder / "statement.md").write_text(FORMS_STATEMENT)
    (folder / "problem.py").write_text(FORMS_MODULE)
    result = judge(load_problem(folder), source, name=name)
    if smallest is None:
        assert (result.verdict.value, result.failure) == ("AC", None)
        return
    assert result.verdict.value == "WA"
    assert (result.counterexample or result.failure).input == smallest
    assert message in (result.counterexample or result.failure).message
