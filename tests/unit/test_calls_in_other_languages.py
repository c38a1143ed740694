"""A class in another language: an object and calls of its methods, in a row."""

import re
from pathlib import Path

import pytest
from native import LIMITS, box_of, fault_of, need, sources
from sampling import daily
from sandboxed import require

import judge
from judge.data.load import load_data
from judge.errors import UsageError
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.languages import language_of
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import Signature, signature_of
from judge.practice.solutions import approaches
from judge.practice.stub import make_stub
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.model import parsed_type
from judge.run.execute import judge_submission
from judge.run.settings import Settings
from judge.sandbox import Containment, Stop
from judge.values.grammar import parse

pytestmark = pytest.mark.slow

KATA = Path(judge.__file__).parent / "manual" / "katas" / "problems" / "least-recently-used"
ACCEPTED = KATA.parents[1] / "solutions" / KATA.name / "accepted"
RIGHT = {f"a.{end}": (ACCEPTED / f"reference.{end}").read_text() for end in ("cpp", "java", "js")}
RIGHT["a.pypy"] = (ACCEPTED / "ordered.py").read_text()
FULL = {  # what of it keeps to the capacity
    "a.cpp": "(long long)pairs.size() > capacity",
    "a.java": "size() > capacity",
    "a.js": "this.values.size > this.capacity",
    "a.pypy": "len(self.values) > self.capacity",
}
RAISES = {  # what of it finds that a key is not there, and what raises there
    "a.cpp": ("return {};", 'throw std::out_of_range("gone");', "std::out_of_range: gone"),
    "a.java": ("return super.get(key);", "return super.get(key) + 0;", "java.lang.NullPointerException"),
    "a.js": ("return null;", "return nothing;", "ReferenceError: nothing is not defined (line 12)"),
    "a.pypy": ("return None", "return 1 // 0", "ZeroDivisionError"),
}
USUAL = ["a.cpp", "a.js"]


def changed(name, old, new):
    assert RIGHT[name].count(old) == 1
    return RIGHT[name].replace(old, new)


def judged(name, source, level=None):
    need(name.rpartition(".")[2])
    problem = load_problem(KATA)
    factory = AnyBoxes(Containment(level), signature_of(problem))
    settings = Settings(box_factory=factory, measured=False)
    return judge_submission(load_data(problem, store=None), source.encode(), name, settings).result


def explained(name, source):
    need(name.rpartition(".")[2])
    with Session(load_problem(KATA), RunOptions(timed=False, named=False)) as session:
        return session.judge(source.encode(), name)


@pytest.mark.parametrize("level", ["full", "strong", "limits"])
@pytest.mark.parametrize("name", daily(RIGHT, USUAL))
def test_a_right_class_is_accepted_and_a_wrong_one_is_not(name, level):
    require(level)
    assert judged(name, RIGHT[name], level).verdict is Verdict.AC
    assert judged(name, changed(name, FULL[name], "1 > 2"), level).verdict is Verdict.WA


@pytest.mark.parametrize(
    ("name", "deed", "verdict"),
    [
        ("a.cpp", "for (volatile int i = 0;; i = i + 1) {}", Verdict.TLE),
        ("a.cpp", "__builtin_trap();", Verdict.RTE),
        ("a.js", "for (;;) {}", Verdict.TLE),
    ],
)
def test_the_call_that_does_not_end_is_marked(name, deed, verdict):
    result = explained(name, changed(name, RAISES[name][0], deed))
    assert result.verdict is verdict
    assert ", in call 1: get(0)" in result.counterexample.message
    assert result.counterexample.shown.splitlines()[-1].startswith("cache.get(0)   ")


@pytest.mark.parametrize("name", daily(RIGHT, USUAL))
def test_an_exception_says_in_which_call(name):
    old, new, told = RAISES[name]
    result = explained(name, changed(name, old, new))
    assert result.verdict is Verdict.RTE
    assert result.failure.message.startswith(told)
    assert re.search(r", in call \d+: (get|put)\(", result.failure.message)
    *_, last = result.counterexample.shown.splitlines()
    assert last.endswith(f"raised {told.partition(': ')[0]}")


@pytest.mark.parametrize("name", daily(RIGHT, USUAL))
def test_the_file_to_begin_with_compiles_and_is_not_written(name):
    stub = make_stub(load_problem(KATA), language_of(name))
    assert ">>> cache.get(1)" in stub
    result = explained(name, stub)
    assert (result.verdict, result.hurdle.kind.value) == (Verdict.RTE, "stub")


POINT = parsed_type("point", Path(judge.__file__).parents[1] / "problems" / "types")
EVERY = (
    "none() -> [text]; rename(place: int, name: text); flag(it: bool) -> bool; "
    "half_of(it: real?) -> real?; fail()"
)
METHODS = parse(f"calls{{{EVERY}}}").methods
POINTS = METHODS[0]._replace(name="point", takes=(("it", POINT),), answer=POINT)
MIRROR = Signature(
    "mirror_all", (("names", parse("[text]")),), METHODS[0].answer, methods=(*METHODS, POINTS), is_run=False
)
SOURCES = sources("classes")


@pytest.mark.parametrize("name", daily(SOURCES, ["a.cpp", "a.js"]))
def test_arguments_and_answers_of_every_type_and_answers_as_they_were(name):
    row = [
        ("none",),
        ("rename", 1, "b c"),
        ("none",),
        ("flag", True),
        ("point", (1.5, 2.0)),
        ("half_of", None),
    ]
    with box_of(name, SOURCES[name], signature=MIRROR) as box:
        assert box.inspect().fault is None, box.inspect().fault
        first, second, third, fourth = box.call(
            "mirror_all()",
            [
                (["a", "true"], [*row, ("half_of", 5.0)]),
                ([], []),
                (["a"], [("none",), ("rename", 3, "b"), ("none",)]),
                (["a"], [("fail",)]),
            ],
            LIMITS,
        ).replies
    words = [{"word": "a"}, {"word": "true"}]
    assert first.answer == [words, None, [{"word": "a"}, {"word": "b c"}], False, [2, 1.5], None, 2.5]
    assert second.answer == []
    assert third.stop is Stop.EXCEPTION
    assert third.detail.endswith(", in call 2: rename(3, 'b')")
    assert fourth.detail.endswith(", in call 1: fail()")


CLASS = signature_of(load_problem(KATA))
PUT = r"void put\(long long key, long long value\)"
ONE_LESS = RIGHT["a.cpp"].replace(
    "put(long long key, long long value) {", "put(long long key) { long long value = 0;"
)
ODD = """struct Odd { Odd() {} Odd(long long) {} explicit operator bool() const { return true; } };

class LRUCache {"""
ODD_ANSWER = (
    RIGHT["a.cpp"].replace("std::optional<long long> get(", "Odd get(").replace("class LRUCache {", ODD)
)
FAULTS = {
    "a.go": ("package main\nfunc main() {}\n", "LRUCache is a class; in Go none is called: write it in"),
    "a.c": ("int main() {}", "in C none is called"),
    "a.rs": ("fn main() {}", "in Rust none is called"),
    "b.cpp": ("int main() {}", "it defines no class LRUCache"),
    "b.pypy": ("class LRUCach:\n    pass\n", "it defines no class LRUCache: write LRUCache for LRUCach"),
    "c.cpp": (RIGHT["a.cpp"].replace("public:", ""), "declared as the problem says: class LRUCache { public"),
    "c.java": ("class LRUCache { LRUCache(long a) {} }", "void put(long key, long value)"),
    "d.cpp": (RIGHT["a.cpp"].replace("put(", "set("), f"^LRUCache must declare: {PUT}$"),
    "e.cpp": (ONE_LESS, f"^LRUCache must declare: {PUT}$"),
    "f.cpp": (ODD_ANSWER, r"^LRUCache must declare: std::optional<long long> get\(long long key\)$"),
}  # fmt: skip


@pytest.mark.parametrize("name", daily(FAULTS, ["a.go", "b.cpp", "c.cpp"]))
def test_what_cannot_be_called_is_told(name):
    source, told = FAULTS[name]
    fault = fault_of(name, source, signature=CLASS)
    assert told in fault.message or re.search(told, fault.message)
    assert fault.line == 0


def test_a_constructor_that_takes_nothing_need_not_be_declared():
    alone = CLASS._replace(parameters=())
    source = RIGHT["a.cpp"].replace("LRUCache(long long capacity) : capacity(capacity) {}", "")
    assert source != RIGHT["a.cpp"]
    fault = fault_of("a.cpp", source.replace("put(", "set("), signature=alone)
    assert re.search(f"^LRUCache must declare: {PUT}$", fault.message)


def test_no_class_is_begun_where_none_is_called():
    with pytest.raises(UsageError, match=r"in Go none is called: write it in Python, C\+\+, Java"):
        make_stub(load_problem(KATA), language_of("a.go"))


def test_a_class_stays_one_where_a_program_was_asked_for():
    need("cpp")
    with Session(load_problem(KATA), RunOptions(timed=False, named=False, program=True)) as session:
        assert session.judge(RIGHT["a.cpp"].encode(), "a.cpp").verdict is Verdict.AC


def test_with_a_format_a_program_may_be_asked():
    need("cpp")
    formatted = CLASS._replace(is_run=True)
    assert fault_of("a.cpp", "int main() {}", signature=formatted) is None
    assert "LRUCache is a class" in fault_of("a.go", "package main\n", signature=formatted).message


def test_the_models_of_a_class_are_found_in_each_language():
    found = [Path(each.file).suffix for each in approaches(load_problem(KATA))]
    assert found[0] == ".py"
    assert {".cpp", ".java", ".js"} < set(found)
