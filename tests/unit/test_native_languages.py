"""Programs and functions in other languages: compiled, kept, called; every type, and how each end is told."""

from array import array

import pytest
from native import LIMITS, answers, box_of, called, fault_of, ran, signature, sources
from sampling import daily
from sandboxed import require

from judge.sandbox import Stop
from judge.sandbox.calls import replies, text

pytestmark = pytest.mark.slow

REAL = signature("real", x="real")

ADDING = sources("adding")  # the sum of two numbers on a line


@pytest.mark.parametrize("name", daily(ADDING, ["a.c", "a.cjs"]))
def test_a_program_is_compiled_and_run(name):
    done = ran(name, ADDING[name], b"19 23\n")
    assert (done.stop, done.stdout, done.detail) == (Stop.ANSWERED, b"42\n", "")
    assert done.usage.memory_bytes > 1 << 20


BROKEN = {  # the line, the column and words of what is told
    "brace.c": (2, 11, "expected"),
    "unknown.cpp": (2, 10, "none"),
    "unused.go": (3, 2, "declared"),
    "expression.java": (2, 10, "illegal start"),
    "type.rs": (2, 15, "mismatched"),
    "twice.js": (2, 5, "SyntaxError"),
    "open.pypy": (2, 0, "SyntaxError"),
}


@pytest.mark.parametrize("name", daily(BROKEN, ["brace.c", "unused.go", "twice.js"]))
def test_what_does_not_compile_is_told_with_its_place(name):
    *place, words = BROKEN[name]
    fault = fault_of(name, sources("broken")[name])
    assert [fault.line, fault.column] == place, fault
    assert words in fault.message
    assert "/" not in fault.message.replace("//", "")


def test_what_was_compiled_is_taken_from_the_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    assert ran("a.c", ADDING["a.c"], b"1 1").stdout == b"2\n"
    monkeypatch.setattr("judge.sandbox.native.compiled", None)
    assert ran("a.c", ADDING["a.c"], b"1 2").stdout == b"3\n"
    with box_of("a.c", ADDING["a.c"] + " ") as box, pytest.raises(TypeError):  # another source is compiled
        box.inspect()


def test_a_kept_program_that_was_changed_is_compiled_again(monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    ran("a.c", ADDING["a.c"], b"1 1")
    for kept in tmp_path.rglob("*.bin"):
        kept.write_bytes(kept.read_bytes()[:-1] + b"?")
    assert ran("a.c", ADDING["a.c"], b"1 2").stdout == b"3\n"


ENDS = {
    "status.c": ("exited", "exit status 7"),
    "signal.c": ("exited", "killed by SIGSEGV"),
    "time.c": ("cpu", "CPU time"),
    "output.c": ("output", "wrote more than"),
    "memory.java": ("memory", "256 MB"),
    "memory.js": ("memory", "JavaScript's own"),
    "fault.cpp": ("exited", "lost"),
    "fault.go": ("exited", "index out of range"),
}


@pytest.mark.parametrize("name", daily(ENDS, ["status.c", "signal.c", "time.c", "output.c", "fault.go"]))
def test_each_end_is_told(name):
    done = ran(name, sources("ends")[name], limits=LIMITS._replace(cpu_seconds=0.5))
    stop, words = ENDS[name]
    assert (done.stop.value, words in done.detail) == (stop, True), (done.stop, done.detail, done.stderr)


LOST = sources("lost")


@pytest.mark.parametrize("level", ["full", "strong"])
@pytest.mark.parametrize("name", daily(LOST, ["a.c"]))
def test_a_program_knows_no_path_of_this_machine(name, level, monkeypatch, tmp_path):
    require(level)
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    done = ran(name, LOST[name], level=level)
    assert done.stop is Stop.EXITED
    assert b"solution" in done.stderr or b"A.java" in done.stderr
    assert b"judge-" not in done.stderr
    assert b"/source" not in done.stderr


# -- functions

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
        return self.box.call("mirror_all", self.given(rows), LIMITS).replies


@pytest.fixture(scope="module", params=daily(EVERYTHING, ["a.c", "a.js"]))
def everything(request):
    name = request.param
    with box_of(name, EVERYTHING[name], signature=POINTS if name == "a.c" else ALL) as box:
        assert box.inspect().fault is None, box.inspect().fault
        yield Everything(name, box)


def test_every_type_passes_unchanged_whatever_is_printed(everything):
    assert [reply.answer for reply in everything.replies(ROWS)] == everything.wanted(ROWS)


@pytest.mark.parametrize(
    "everything", daily([name for name in EVERYTHING if name != "a.c"], ["a.js"]), indirect=True
)  # C raises nothing
def test_what_is_raised_costs_its_own_call(everything):
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


# -- integers of any length ------------------------------------------------------------

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


# -- what goes between ------------------------------------------------------------


def test_answers_are_foreign_data():
    assert replies(b'[0,1]\n[0,[1,"a"]]\n[0', 3)[0] == replies(b'[0,1]\n[0,[1,"a"]]\n', 3)[0]
    assert replies(b"[0,1]\n[0,2]\n", 1)[1] is False
    assert replies(b"hello\n", 1) == ([], False)
    assert replies(b"[2,1]\n", 1) == ([], False)


def test_arguments_are_written_as_tokens():
    assert text([(1, 0.1, (2, "left"), [(1, 2)], None)]) == b"1 0\n1 0.1 2 left 1 1 2 none\n"
    assert text([("a b", "none", "a_b-1", "\n", "", True, [False])]) == (
        b"1 0\n=612062 =6e6f6e65 a_b-1 =0a = true 1 false\n"
    )
    assert text([([], [0.5, 3], array("d", [1, 2.5]), [[1], []])]) == b"1 0\n0 2 0.5 3 2 1.0 2.5 2 1 1 0\n"


# -- functions as people write them


def test_a_stack_without_end_and_more_memory_than_there_is_are_said_so():
    source = """package main
func deep(x float64) float64 { return deep(x) + 1 }
func mirrorAll(x float64) float64 {
    if x == 2 { return deep(x) }
    if x == 4 { all := make([]float64, 1<<33); all[5] = x; return all[int(x)] }
    return x }"""
    with box_of("a.go", source, signature=REAL) as box:
        deep, large = (box.call("mirror_all", [(1.0,), (x,), (3.0,)], LIMITS).replies for x in (2.0, 4.0))
    assert [reply.stop for reply in deep] == [Stop.ANSWERED, Stop.EXITED]
    assert deep[1].detail.endswith("stack overflow")
    assert [reply.stop for reply in large] == [Stop.ANSWERED, Stop.MEMORY]


PLACED = signature("[point; 0..2]", A="point")
OWN = sources("own")  # types, fields and names of the submission's own, as people have them


@pytest.mark.parametrize("name", daily(OWN, ["grouped.go", "tag.c"]))
def test_types_and_names_of_its_own_are_taken(name):
    assert answers(name, OWN[name], PLACED, [((1.5, 2.0),)]) == [[[2, 1.5]]]


# -- functions as people write them ------------------------------------------------------------


@pytest.mark.parametrize(
    "source",
    [
        "export default function mirrorAll(x) { return -x; }",
        "const mirrorAll = x => -x;\nmodule.exports = { mirrorAll };\n",
        "const all = 'src/*', some = /[\"'`/]/g;\nfunction mirrorAll(x) { return -x; }\nlet none = '*/';",
    ],
)
def test_what_a_script_exports_is_called_all_the_same(source):
    assert answers("a.mjs", source, REAL, [(2.5,)]) == [-2.5]


JAVA = sources("java")


@pytest.mark.parametrize("name", daily(JAVA, ["after.java"]))
def test_java_functions_are_found_wherever_they_stand(name):
    assert answers(name, JAVA[name], REAL, [(2.5,)]) == [-2.5]


# -- what stands around the function ------------------------------------------------------------

MEDDLING = sources("meddling")  # macros, pragmas and names that files of contests begin with


def test_macros_of_ones_own_do_not_reach_the_driver():
    assert answers("a.c", MEDDLING["a.c"], REAL, [(1.0,), (2.5,)]) == [-1, -2.5]


@pytest.mark.nightly
def test_nor_do_those_of_cpp_nor_does_fast_mathematics_which_has_no_nan():
    *plain, nan = answers("a.cpp", MEDDLING["a.cpp"], REAL, [(1.0,), (2.5,), (3.0,)])
    assert (plain, nan) == ([-1, -2.5], {"type": "float", "text": "nan"})


@pytest.mark.parametrize(
    ("name", "source", "words"),
    [
        (
            "a.cpp",
            "double mirrorAll(double x) { return x; }",
            "neither mirror_all nor main: write mirror_all for mirrorAll",
        ),
        (
            "a.js",
            "class Solution {\n  mirrorAll(x) { return -x; }\n}",
            "mirrorAll is a method of Solution: write it as a function",
        ),
        (
            "a.js",
            "function mirror_all(x) { return x; }\nconsole.log(mirror_all(1));",
            "it defines no mirrorAll, and reads no input: write mirrorAll for mirror_all",
        ),
    ],
)
def test_neither_function_nor_program_is_told(name, source, words):
    with box_of(name, source, signature=REAL) as box:
        assert box.inspect().fault.message.endswith(words)


# -- what cannot be linked

_HUGE = "static int a[1000000000], b[1000000000]; int main(void) { a[5] = b[7]; return a[3] + b[2]; }"


@pytest.mark.parametrize(
    ("name", "source", "told"),
    [
        ("a.c", _HUGE, "its arrays take more than the 2 GB that can be linked"),
        ("a.c", "int f(int); int main(void) { return f(1); }", "undefined reference to `f'"),
    ],
)
def test_what_cannot_be_linked(name, source, told):
    assert fault_of(name, source).message == told
