"""Dicts: read, compared, told, drawn, kept and made smaller."""

from __future__ import annotations

import json
from collections import Counter

import pytest
from native import need

from judge import judge
from judge.data.load import load_data
from judge.data.parse import line_of, read_case
from judge.diagnose.candidates import measure
from judge.diagnose.replay import decode, encode
from judge.errors import ProblemError
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.report.words import arguments
from judge.run.result import Mode
from judge.sandbox.encode import encode as sent
from judge.testing import JudgeProblem
from judge.values import check, parameters
from judge.values.answers import AnyOf, Judged, Real, Tolerance
from judge.values.check import Accepted
from judge.values.grammar import TypeFault, parse


def told(text, exact, given, *, line=False):
    """Why that answer is wrong; empty for a right one."""
    type_ = parse(text)
    target = json.loads(json.dumps(check.target(type_, exact, Tolerance())))
    target = _tupled(target)
    raw = given if line else json.loads(json.dumps(sent(given)))
    found = (check.check_line if line else check.check)(type_, raw, target, lambda: (exact, Tolerance()))
    return "" if isinstance(found, Accepted) else found.message


def _tupled(value):
    if isinstance(value, dict):
        return {key: _tupled(each) for key, each in value.items()}
    return tuple(map(_tupled, value)) if isinstance(value, list) else value


AB = {"a": 1, "b": 3}


@pytest.mark.parametrize(
    ("text", "exact", "given", "why"),
    [
        ("{text: int}", AB, {"b": 3, "a": 1}, ""),
        ("{text: int}", AB, Counter("abbb"), ""),
        ("{text: int}", {}, {}, ""),
        ("{int: [int]}", {2: [1], 10: []}, {10: [], 2: (1,)}, ""),
        ("{int: int}", {1 << 70: 1, 3: 1}, {1 << 70: 1, 3: 1}, ""),
        ("{bool: int}", {True: 1, False: 2}, {True: 1, False: 2}, ""),
        ("{word(up|down): int?}", {"up": None, "down": 1}, {"up": None, "down": 1}, ""),
        ("{int: real}", {1: Real(2)}, {1: 2}, ""),
        ("{int: int}", {1: AnyOf([2, 3])}, {1: 3}, ""),
        ("{text: int}", AB, {"a": 1, "b": 5}, "entry 'b': 3 expected, 5 given"),
        ("{text: int}", AB, {"a": 1}, "no entry 'b'"),
        ("{text: int}", AB, {**AB, "c": 0}, "an entry 'c' too many"),
        ("[{text: int}]", [AB], [{"a": 1}], "item 1: no entry 'b'"),
        ("{int: {int: int}}", {1: {2: 3}}, {1: {2: 4}}, "entry 2 of entry 1: 3 expected, 4 given"),
        ("{int: real}", {1: Real(2)}, {1: 3.0}, "entry 1 is off by 1, relative error 0.5"),
        ("{text: int}", AB, {"a": 1, 2: 3}, "2 where a text is expected for a key"),
        ("{int: int}", {1: 2}, {1.0: 2}, "the float 1.0 where a key is expected as an int"),
        ("{int: int}", {1: 2}, {True: 2}, "the bool True where a key is expected"),
        ("{text: int}", AB, [("a", 1), ("b", 3)], "a list where a dict of texts to ints is expected"),
        ("{text: int}", {}, None, "None where a dict of texts to ints is expected: no entries are {}"),
        ("{text: int; 0..2}", AB, {**AB, "c": 1}, "the answer has 3 entries where 0 to 2 are expected"),
        ("[(text, int)]", [("a", 1)], {"a": 1}, "a dict where a list of tuples is expected"),
        ("int", 1, {}, "a dict where an int is expected"),
    ],
)
def test_what_is_told_of_a_dict(text, exact, given, why):
    assert told(text, exact, given) == why


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ("2 a 1 b 3", ""),
        ("2 b 3 a 1", ""),
        ("2 a 1 b 5", "entry 'b': 3 expected, 5 given"),
        ("1 a 1", "no entry 'b'"),
        ("2 a 1 a 3", "the key 'a' is there twice"),
        ("3 a 1 b 3", "k = 3 needs 6 more, 4 given"),
    ],
)
def test_what_is_told_of_a_programs_dict(given, why):
    assert told("{text: int}", AB, given, line=True) == why


@pytest.mark.parametrize(
    ("text", "what", "remedy"),
    [
        ("{real: int}", "the keys of a dict are ints, words, texts or bools", "T?"),
        ("{int?: int}", "the keys of a dict are ints, words, texts or bools", "T?"),
        ("{int}", "'}' where ':' is expected", "T?"),
        ("{int: int; 3..2}", "the bounds leave no length: low is above high", "T?"),
        ("dict", "'dict' is unknown", "{K: V}"),
    ],
)
def test_what_is_told_of_a_wrong_type(text, what, remedy):
    with pytest.raises(TypeFault) as raised:
        parse(text)
    assert what in raised.value.what
    assert remedy in raised.value.remedy


def test_a_forged_dict_is_a_wrong_answer():
    for raw in (
        {"dict": [[{"word": "a"}, 1], [{"word": "a"}, 1]]},
        {"dict": [["a", 1], ["b", 3]]},
        {"dict": [[{"word": "a"}]]},
        {"dict": {"a": 1, "b": 3}},
        {"dict": [[[], 1], [{}, 2]]},
        {"dict": [[{"word": "a"}, 1], [{"word": "b"}, 3]], "word": "a"},
    ):
        type_ = parse("{text: int}")
        assert not check.is_right(type_, raw, (("a", 1), ("b", 3)), lambda: (AB, Tolerance()))
        assert check.check(type_, raw, (("a", 1), ("b", 3)), lambda: (AB, Tolerance())).message.isprintable()


def test_a_checker_gets_a_dict():
    asked = []
    exact = Judged(lambda value, _: asked.append(value), {1: [2.5]})
    assert told("{int: [int]}", Judged(exact.why_not, {1: [2]}), {3: [4]}) == ""
    assert asked == [{3: [4]}]


def test_a_dict_is_shrunk_as_small_as_by_hand():
    type_, value = parse("{text: [int]}"), (("ab", (1, 2)), ("b", ()), ("c", (3,)))
    found = set(parameters.simpler(type_, value))
    assert all(parameters.fault(type_, "d", each) is None for each in found)
    assert {(), (("a", (1, 2)), ("b", ()), ("c", (3,))), (("ab", (1, 2)), ("b", ()))} <= found
    assert all(measure((each,)) <= measure((value,)) for each in found)


# -- a kata of dicts ---------------------------------------------------------------------------------------

TOML = """
title = "Turned"
tier = "junior"
summary = "Keys by their value."
entry = "turned"
answer = "{int: [text]}"

[parameters]
d = { type = "{text(1..3): int(0..9); 0..4}", letters = "a-c", about = "a dict" }
"""
STATEMENT = """# Turned

    >>> turned({'b': 1, 'a': 1})
    {1: ['a', 'b']}
"""
MODULE = """
from judge.problem.declare import group

def solve(d):
    return {value: [key for key in sorted(d) if d[key] == value] for value in d.values()}

def some(draw):
    return {draw.choice("abc") * draw.integer(1, 2): draw.integer(0, 3) for _ in range(draw.integer(0, 4))},

GROUPS = [group("some", "Some.", some, cases=9)]
"""
RIGHT = """
def turned(d):
    found = {}
    while d:
        key, value = d.popitem()
        found.setdefault(value, []).append(key)
    return {value: sorted(keys) for value, keys in found.items()}
"""


@pytest.fixture
def made(tmp_path, monkeypatch):
    """Writes the kata, with some texts replaced in its files."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))

    def made(*edits):
        folder = tmp_path / "problems" / "turned"
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in (("problem.toml", TOML), ("statement.md", STATEMENT), ("problem.py", MODULE)):
            for old, new in edits:
                text = text.replace(old, new)
            (folder / name).write_text(text, encoding="utf-8")
        return folder

    return made


def test_a_kata_of_dicts_is_read_drawn_and_kept(made):
    folder = made()
    problem, again = load_problem(folder), load_problem(folder)
    assert again == problem
    assert repr(again.examples[0].wanted) == "{1: ['a', 'b']}"
    drawn, kept = load_data(problem), load_data(problem)
    assert [each.cases for each in drawn.groups] == [each.cases for each in kept.groups]
    assert [each.targets for each in drawn.groups] == [each.targets for each in kept.groups]
    case = problem.examples[0].case
    assert case == ((("a", 1), ("b", 1)),)
    assert list(problem.calls([case])) == [({"a": 1, "b": 1},)]
    assert arguments(problem.named(case)) == "d={'a': 1, 'b': 1}"
    assert line_of(problem, case) == "2 a 1 b 1"
    for text in ("{'b': 1, 'a': 1}", "turned({'a': 1, 'b': 1})", "2 b 1 a 1"):
        assert read_case(problem, text) == case
    module, group = load_module(problem), problem.groups[1]
    replay = encode(problem, group, case)
    assert decode(replay, problem, module).case == case


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        (
            "{'b': 1, 'a': 1}",
            "{'b': 1, 2: 1}",
            "the example is invalid: d has a key 2 where a text is expected",
        ),
        (
            "{1: ['a', 'b']}",
            "{1: ['a']}",
            "solve: entry 1: 2 items expected, 1 given",
        ),
        ("{1: ['a', 'b']}", "[(1, ['a', 'b'])]", "the example's answer \"[(1, ['a', 'b'])]\" is none"),
        ("sorted(d)", "[2]", "solve"),
        ("draw.integer(0, 3)", "12", "group 'some' draws a case out of bounds: d has 12, outside 0 to 9"),
        ('draw.choice("abc")', '"d"', "d has 'd', none of its letters 'a-c'"),
        ("{value: [", "{str(value): [", "the exact answer is no {int: [text]}: a key '1', a str"),
    ],
)
def test_a_setters_faults_of_dicts_are_told_in_a_line(made, old, new, what):
    folder = made((old, new))
    with pytest.raises(ProblemError) as raised:
        load_data(load_problem(folder), store=None)
    assert what in raised.value.what


def test_a_dict_is_judged_and_the_smallest_failing_case_is_shown(made):
    problem = load_problem(made())
    assert judge(problem, RIGHT).verdict is Verdict.AC
    result = judge(problem, RIGHT.replace("sorted(keys)", "keys[:1]"))
    small = result.counterexample
    assert json.loads(json.dumps(small.input)) == {"d": [["a", 0], ["b", 0]]}
    assert repr(small.input["d"]) == "{'a': 0, 'b': 0}"
    assert small.message == "entry 0: 2 items expected, 1 given"


def test_who_tests_a_library_gets_dicts(made):
    problem = JudgeProblem(load_problem(made()))
    for case in problem.cases():
        (d,) = case
        assert type(d) is type(case.d) is dict
        assert d == case.d
        assert repr(case) == f"Case(d={d!r})"
        assert case.accepts({value: sorted(key for key in d if d[key] == value) for value in d.values()})


CLASS_TOML = """
title = "Store"
tier = "junior"
summary = "Counts."
entry = "Store"

[parameters]
d = { type = "{int(0..9): int(0..9); 0..3}", about = "what is there" }

[methods]
more = "(d: {int(0..9): int(0..9); 1..3})"
all = "() -> {int: int}"
"""
CLASS_STATEMENT = """# Store

    >>> store = Store({2: 1})
    >>> store.more({3: 1, 2: 4})
    >>> store.all()
    {2: 5, 3: 1}
"""
CLASS_MODULE = """
from judge.problem.declare import group

class Store:
    def __init__(self, d):
        self.d = dict(d)

    def more(self, d):
        for key, value in d.items():
            self.d[key] = self.d.get(key, 0) + value

    def all(self):
        return self.d

def some(draw):
    d = lambda: {draw.integer(0, 9): draw.integer(0, 9) for _ in range(draw.integer(1, 3))}
    return d(), (("more", d()), ("all",), ("more", d()), ("all",))

GROUPS = [group("some", "Some.", some, cases=20)]
"""


def test_a_class_takes_and_returns_dicts(made):
    edits = ((TOML, CLASS_TOML), (STATEMENT, CLASS_STATEMENT), (MODULE, CLASS_MODULE), ("turned", "store"))
    folder = made(*edits)
    first, problem = load_problem(folder), load_problem(folder)
    assert problem == first
    assert repr(problem.examples[0].wanted) == "[None, None, {2: 5, 3: 1}]".replace("None, ", "", 1)
    right = CLASS_MODULE.partition("def some")[0].partition("\n\n")[2]
    result = judge(problem, right)
    assert (result.verdict, result.failure, result.notes) == (Verdict.AC, None, ())
    result = judge(problem, right.replace("self.d.get(key, 0) + value", "value"))
    assert "entry" in result.counterexample.message
    calls = json.loads(json.dumps(result.counterexample.input))["calls"]
    assert [name for name, *_ in calls] == ["more", "all"]


OTHERS = {
    "turned.cpp": """
#include <map>
#include <string>
#include <vector>
std::map<long long, std::vector<std::string>> turned(const std::map<std::string, long long>& d) {
    std::map<long long, std::vector<std::string>> found;
    for (const auto& [key, value] : d) found[value].push_back(key);
    return found;
}
""",
    "Turned.java": """
import java.util.*;
class Solution {
    static Map<Long, List<String>> turned(Map<String, Long> d) {
        var found = new TreeMap<Long, List<String>>();
        for (var key : new TreeSet<>(d.keySet())) {
            found.putIfAbsent(d.get(key), new ArrayList<>());
            found.get(d.get(key)).add(key);
        }
        return found;
    }
}
""",
    "turned.go": """
package main

import "sort"

func turned(d map[string]int) map[int][]string {
	found := map[int][]string{}
	for key, value := range d {
		found[value] = append(found[value], key)
	}
	for _, keys := range found {
		sort.Strings(keys)
	}
	return found
}
""",
    "turned.rs": """
use std::collections::{BTreeMap, HashMap};
fn turned(d: BTreeMap<String, i64>) -> HashMap<i64, Vec<String>> {
    let mut found: HashMap<i64, Vec<String>> = HashMap::new();
    for (key, value) in d { found.entry(value).or_default().push(key) }
    found
}
""",
    "turned.js": """
function turned(d) {
  const found = new Map();
  for (const key of [...d.keys()].sort()) found.set(d.get(key), [...(found.get(d.get(key)) || []), key]);
  return found;
}
""",
    "object.js": """
function turned(d) {
  const found = {};
  for (const [key, value] of [...d].sort()) (found[value] = found[value] || []).push(key);
  return found;
}
""",
    "turned.kt": """
fun turned(d: Map<String, Long>): Map<Long, List<String>> {
    val found = mutableMapOf<Long, List<String>>()
    for (key in d.keys.sorted()) found[d[key]!!] = (found[d[key]!!] ?: listOf()) + key
    return found
}
""",
    "turned.pypy.py": RIGHT,
}
WRONG = {  # what makes them wrong: an answer's entry is missing
    ".cpp": ("return found;", "found.erase(0); return found;"),
    ".java": ("return found;", "found.remove(0L); return found;"),
    ".go": ("return found", "delete(found, 0); return found"),
    ".rs": ("    found\n}", "    found.remove(&0); found\n}"),
    "d.js": ("return found;", "found.delete(0); return found;"),
    "t.js": ("return found;", "delete found[0]; return found;"),
    ".kt": ("return found", "return found - 0L"),
    ".py": ("in found.items()}", "in found.items() if value}"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHERS)
def test_a_dict_in_other_languages(made, name):
    problem, source = load_problem(made()), OTHERS[name].encode()
    need("pypy" if "pypy" in name else name.rpartition(".")[2])
    result = judge(problem, source, name=name)
    assert (result.verdict, result.mode, result.failure) == (Verdict.AC, Mode.FUNCTION, None)
    old, new = next(edit for end, edit in WRONG.items() if name.endswith(end))
    assert source.decode().count(old) == 1
    result = judge(problem, source.decode().replace(old, new), name=name)
    small = result.counterexample
    assert (result.verdict, small.message) == (Verdict.WA, "no entry 0")
    assert repr(small.input) == "{'d': {'a': 0}}"
