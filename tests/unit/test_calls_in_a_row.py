"""Katas of classes: a case is an object and calls of its methods, in a row."""

import shutil
from pathlib import Path

import pytest

import judge
from judge.data.load import load_data
from judge.diagnose.replay import decode
from judge.errors import ProblemError
from judge.judging import RunOptions
from judge.judging.inprocess import InProcess
from judge.judging.session import Session
from judge.languages.signature import signature_of
from judge.practice.stub import make_stub
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.report.entry import entry_text
from judge.report.tell import tell
from judge.run.entry import entry_error
from judge.run.execute import judge_submission
from judge.run.settings import Settings
from judge.testing import judge_problem
from judge.verify.gate import Options, verify_problem

KATAS = Path(judge.__file__).parent / "manual" / "katas"
ID = "least-recently-used"
RIGHT = (KATAS / "solutions" / ID / "accepted" / "ordered.py").read_text()
FORGETS_NOTHING = RIGHT.replace("if len(self.values) > self.capacity:", "if False:")


@pytest.fixture
def cache(tmp_path):
    """The folder of a copy of the kata, to be changed."""
    for kind in ("problems", "solutions"):
        shutil.copytree(KATAS / kind / ID, tmp_path / kind / ID)
    return tmp_path / "problems" / ID


def change(file, old, new):
    text = file.read_text()
    assert text.count(old) == 1
    file.write_text(text.replace(old, new))


def judged(folder, source, box=None):
    data = load_data(load_problem(folder), store=None)
    return judge_submission(data, source.encode(), "mine.py", Settings(measured=False), box=box)


def explained(folder, source):
    """The whole result, and what is said of it."""
    problem = load_problem(folder)
    with Session(problem, RunOptions(timed=False, named=False)) as session:
        result = session.judge(source.encode(), "mine.py")
    return result, tell(problem, result, source.encode())


def test_a_right_class_is_accepted_in_a_container_and_in_process(cache):
    assert judged(cache, RIGHT).result.verdict is Verdict.AC
    assert judged(cache, RIGHT, InProcess(RIGHT.encode(), "mine.py")).result.verdict is Verdict.AC
    assert judged(cache, FORGETS_NOTHING, InProcess(FORGETS_NOTHING.encode())).result.verdict is Verdict.WA


def test_the_smallest_case_is_shown_as_calls(cache):
    result, told = explained(cache, FORGETS_NOTHING)
    assert result.counterexample.shown.splitlines()[-1].endswith("None expected, 0 given")
    assert len(result.counterexample.input["calls"]) == 3
    assert [label for label, _ in told.facts] == ["calls", "why"]
    assert dict(told.facts)["why"] == "the third call, get(0), gave 0; None is expected"


def test_the_smallest_case_can_be_asked_again(cache):
    result, _ = explained(cache, FORGETS_NOTHING)
    problem = load_problem(cache)
    found = decode(result.counterexample.replay, problem, load_module(problem))
    calls = tuple(map(tuple, result.counterexample.input["calls"]))
    assert found.case == (1, calls)


def test_an_exception_says_in_which_call(cache):
    result, told = explained(cache, RIGHT.replace("return None", "return 1 // key // 0"))
    assert result.verdict is Verdict.RTE
    assert "ZeroDivisionError" in result.failure.message
    assert ", in call " in result.failure.message
    assert result.counterexample.shown.splitlines()[-1].endswith("raised ZeroDivisionError")
    assert "calls" in dict(told.facts)


FULL = "if len(self.values) > self.capacity:\n            "


@pytest.mark.parametrize(
    ("deed", "row"),
    [
        ("while True: pass", "of CPU time"),
        ("__import__('os').abort()", "killed by SIGABRT"),
        ("[0] * 10**10", "raised MemoryError"),
        ("__import__('os')._exit(3)", "exit status 3"),
    ],
)
def test_the_call_that_does_not_end_is_marked(cache, deed, row):
    """It is known to be the last of the smallest case; of the first case nothing is said."""
    result, told = explained(cache, RIGHT.replace(FULL, f"{FULL}{deed}\n            "))
    first, *_, last = result.counterexample.shown.splitlines()
    assert first == "cache = LRUCache(1)"
    assert last.startswith("cache.put(1, 0)   ")
    assert last.endswith(f" {row}")
    assert "in call 2: put(1, 0)" in told.happened
    assert "None" not in result.failure.shown


def test_a_constructor_that_does_not_end_marks_no_call(cache):
    result, told = explained(cache, RIGHT.replace("self.capacity = capacity", "__import__('os').abort()"))
    assert result.counterexample.shown == "cache = LRUCache(1)"
    assert "in call" not in told.happened


def test_what_ended_it_is_said_of_the_case_that_is_shown(cache):
    wrong = RIGHT.replace("return None", "return None if len(self.values) < 2 else 1 // 0")
    result, told = explained(cache, wrong)
    called = result.counterexample.shown.splitlines()[-1].partition("  ")[0].removeprefix("cache.")
    assert told.happened.endswith(f"in call {len(result.counterexample.input['calls'])}: {called}")
    assert told.source
    assert called not in result.failure.message


@pytest.mark.parametrize(
    "raised", ["1 / 0", "raise SystemExit", "raise KeyboardInterrupt", "raise OSError(self)"]
)
def test_a_constructor_that_fails(cache, raised):
    result = judged(cache, RIGHT.replace("self.capacity = capacity", raised)).result
    assert result.verdict is Verdict.RTE
    assert ", in call" not in result.failure.message


def test_an_answer_is_what_it_was_when_it_was_returned(cache):
    """A method may return its own list, which grows later."""
    change(cache / "problem.toml", 'get = "(key: int(0..9)) -> int?"', 'get = "(key: int(0..9)) -> [int]"')
    change(cache / "problem.py", "return pair[1]\n        return None", "return [pair[1]]\n        return []")
    change(cache / "statement.md", "    10\n", "    [10]\n")
    change(
        cache / "statement.md", ">>> cache.get(1)\n    >>> cache.get(2)\n    20", ">>> cache.get(1)\n    []"
    )
    grows = (
        "class LRUCache:\n"
        "    def __init__(self, capacity):\n        self.capacity, self.pairs, self.said = capacity, [], []\n"
        "    def get(self, key):\n        self.said.clear()\n"
        "        for pair in self.pairs:\n            if pair[0] == key:\n"
        "                self.pairs.remove(pair)\n                self.pairs.append(pair)\n"
        "                self.said.append(pair[1])\n                break\n        return self.said\n"
        "    def put(self, key, value):\n"
        "        self.pairs = [pair for pair in self.pairs if pair[0] != key] + [(key, value)]\n"
        "        self.pairs = self.pairs[-self.capacity :]\n"
    )
    assert judged(cache, grows).result.verdict is Verdict.AC


def test_what_a_method_without_answer_returns_is_not_looked_at(cache):
    odd = RIGHT.replace("self.values.pop(key, None)", "self.values.pop(key, None)").rstrip()
    assert judged(cache, f"{odd}\n        return object()\n").result.verdict is Verdict.AC


@pytest.mark.parametrize(
    ("source", "told"),
    [
        (
            "def LRUCache(capacity):\n    return 1\n",
            "LRUCache is a function (line 1); the kata asks",
        ),
        ("import sys\nprint(sys.stdin.read())\n", "The kata asks for a class, and a program cannot be asked"),
        ("class LRUCach:\n    pass\n", "is LRUCach (line 1) meant? Rename it: class LRUCache"),
    ],
)
def test_what_is_no_such_class_is_told(cache, source, told):
    result, runner, _ = judged(cache, source)
    error = entry_error(result, runner, InProcess(source.encode()).inspect(), source.encode())
    text = entry_text(error, load_problem(cache), "mine.py", result.verdict, result.failure.message)
    assert told in text


def test_a_method_that_is_missing(cache):
    result, told = explained(cache, RIGHT.partition("    def put")[0])
    assert result.verdict is Verdict.RTE
    assert "has no attribute 'put', in call 1: put(1, 10)" in result.failure.message
    assert "has no attribute 'put'" in told.happened


def test_the_file_to_begin_with_is_a_class_that_is_not_written(cache):
    stub = make_stub(load_problem(cache))
    assert "    >>> cache.get(1)\n    10\n" in stub
    assert "def get(self, key: int) -> int | None:" in stub
    result, _ = explained(cache, stub)
    assert (result.verdict, result.hurdle.kind.value) == (Verdict.RTE, "stub")


def test_a_class_of_ones_own_is_held_against_it(cache):
    names = {}
    exec(FORGETS_NOTHING, names)
    with pytest.raises(AssertionError, match="the third call"):
        judge_problem(ID, problems=[cache.parent]).check(names["LRUCache"])
    exec(RIGHT, names)
    judge_problem(ID, problems=[cache.parent]).check(names["LRUCache"])


def test_real_numbers_in_an_answer_have_the_tolerance(cache):
    change(cache / "problem.toml", "-> int?", "-> real?")
    change(cache / "problem.toml", "[parameters]", "tolerance = { relative = 1e-6 }\n\n[parameters]")
    change(cache / "problem.py", "return pair[1]", "return Real(Fraction(pair[1], 3))")
    change(cache / "problem.py", "import group", "import Real, group\nfrom fractions import Fraction")
    change(cache / "statement.md", "    10\n", "    3.3333333333\n")
    change(cache / "statement.md", "    20\n", "    6.6666666667\n")
    third = RIGHT.replace("return value", "return value / 3 * (1 + FACTOR)")
    assert judged(cache, third.replace("FACTOR", "1e-8")).result.verdict is Verdict.AC
    wrong = judged(cache, third.replace("FACTOR", "1e-4")).result
    assert wrong.verdict is Verdict.WA
    assert "relative error 0.0001" in wrong.failure.message


@pytest.mark.parametrize(
    ("file", "old", "new", "told"),
    [
        ("problem.toml", 'entry = "LRUCache"', 'entry = "LRUCache"\nanswer = "int"', "a class has no answer"),
        ("problem.toml", 'entry = "LRUCache"\n', "", "[methods] needs entry, the class's name"),
        ("problem.toml", '"(key: int(0..9)) -> int?"', '"key: int"', "methods.get = 'key: int'"),
        ("problem.toml", '"(key: int(0..9)) -> int?"', '"(key) -> int"', "methods.get = '(key) -> int'"),
        ("problem.toml", '"(key: int(0..9)) -> int?"', '"(key: itn) -> int"', "'itn' is unknown"),
        ("problem.py", "class LRUCache", "class Cache", "no class 'LRUCache' with get, put"),
        ("problem.py", "def put(self", "def set(self", "no class 'LRUCache' with get, put"),
        ("problem.py", "def put(self, key, value)", "def put(self, key)", "put takes other arguments"),
        ("problem.py", "def __init__(self, capacity)", "def __init__(self)", "takes other arguments"),
        ("statement.md", ">>> cache.put(1, 10)", ">>> cache.pop(1)", "a call of get or put is expected"),
        ("statement.md", ">>> cache.put(1, 10)", ">>> cache.put(1)", "put takes key, value"),
        ("statement.md", ">>> cache.put(1, 10)", ">>> other.put(1, 10)", "is no call with plain values"),
        ("statement.md", ">>> cache = LRUCache(1)", ">>> cache = LRUCache()", "of other arguments"),
    ],
)  # fmt: skip
def test_wrong_use_is_told(cache, file, old, new, told):
    change(cache / file, old, new)
    with pytest.raises(ProblemError) as fault:
        load_problem(cache)
    assert told in fault.value.what
    assert fault.value.remedy
    assert fault.value.where.startswith(f"{ID}/{file}")


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('("put", key, draw', '("pop", key, draw', "where a call of get or put is expected"),
        ("draw.integer(0, 99)))", "draw.integer(100, 109)))", "outside 0 to 99, as value of put"),
    ],
)
def test_a_draw_of_other_calls_is_told(cache, old, new, told):
    change(cache / "problem.py", old, new)
    with pytest.raises(ProblemError) as fault:
        load_data(load_problem(cache), store=None)
    assert told in fault.value.what


def test_a_method_that_no_example_calls_is_told(cache):
    statement = cache / "statement.md"
    statement.write_text(statement.read_text().partition("    >>> cache.get(1)")[0])
    found = verify_problem(load_problem(cache), Options(pin=True))
    assert [each.what for each in found.warnings] == ["no example calls get"]


def test_a_large_number_needs_bounds(cache):
    """Other languages must know of it."""
    change(cache / "problem.py", "draw.integer(0, 99)))", "10**20))")
    assert not signature_of(load_problem(cache)).big
    change(cache / "problem.toml", "value: int(0..99)", "value: int")
    with pytest.raises(ProblemError, match="as value of put: give its type bounds"):
        load_data(load_problem(cache), store=None)
    change(cache / "problem.toml", "value: int", f"value: int(0..{10**20})")
    assert signature_of(load_problem(cache)).big
    assert judged(cache, RIGHT).result.verdict is Verdict.AC
