"""Programs and functions in other languages: compiled, kept, called; every type, and how each end is told."""

import re
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
    "type.kt": (2, 18, "mismatch"),
}


@pytest.mark.parametrize("name", daily(BROKEN, ["brace.c", "unused.go", "twice.js"]))
def test_what_does_not_compile_is_told_with_its_place(name):
    *place, words = BROKEN[name]
    fault = fault_of(name, sources("broken")[name])
    assert [fault.line, fault.column] == place, fault
    assert words in fault.message
    assert "/" not in fault.message.replace("//", "")


DOUBTFUL = """double half(double x) {
    if (x > 0) return x / 2;
}
double mirror_all(double x) {
    long long sum;
    int whole = x;
    for (int i = 0; i < whole; i++) sum += i;
    return half(x) + sum;
}
"""
WARNED = {
    "the compiler warns: control reaches end of non-void function (line 3)",
    "the compiler warns: conversion from ‘double’ to ‘int’ may change value (line 6)",
}


@pytest.mark.parametrize("name", ["a.c", "a.cpp"])
def test_what_a_compiler_warns_of_is_told_whether_it_is_compiled_or_kept(name, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    for _ in range(2):
        with box_of(name, DOUBTFUL, signature=REAL) as box:
            warned = box.inspect().warnings
        assert set(warned) > WARNED
        assert "uninitialized" in "".join(warned)
        monkeypatch.setattr("judge.sandbox.native.compiled", None)
    monkeypatch.undo()
    with box_of(name, "double mirror_all(double x) { return x; }", signature=REAL) as box:
        assert box.inspect().warnings == ()


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
LEFT |= {"a.rs": "status 4", "a.js": "mid-call", "a.pypy": "status 5", "a.kt": "status 3"}


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


RAISED = {  # a function that raises in its third line, and what is told of that
    "a.cpp": (
        "#include <vector>\ndouble mirror_all(double x) {\n return std::vector<double>().at(x); }",
        r"std::out_of_range: vector::.*size\(\) \(which is 0\)",
    ),
    "a.go": (
        "package main\nfunc mirrorAll(x float64) float64 {\n return []float64{}[int(x)] }",
        r"runtime error: index out of range \[2\] with length 0 \(line 3\)",
    ),
    "A.java": (
        "class A {\n static double mirrorAll(double x) {\n return new double[] {}[(int) x]; } }",
        r"java\.lang\.ArrayIndexOutOfBoundsException: Index 2 out .* \(line 3\)",
    ),
    "a.js": (
        "function mirrorAll(x) {\n let a = null;\n return a.b; }\n",
        r"TypeError: Cannot read properties of null .* \(line 3\)",
    ),
    "a.rs": (
        "fn mirror_all(x: f64) -> f64 {\n let a: Vec<f64> = vec![];\n a[x as usize] }",
        r"panic: index out of bounds: the len is 0 but the index is 2 \(line 3\)",
    ),
    "a.kt": (
        "fun mirrorAll(x: Double): Double {\n val a = listOf<Double>()\n return a[x.toInt()] }",
        r"java\.lang\.IndexOutOfBoundsException: .* \(line 3\)",
    ),
    "a.pypy": ("def mirror_all(x):\n    a = []\n    return a[int(x)]", r"IndexError: .* \(line 3\)"),
}


@pytest.mark.parametrize("name", daily(RAISED, ["a.js", "a.cpp"]))
def test_what_is_raised_is_told_with_its_type_and_line(name):
    source, told = RAISED[name]
    (reply,) = called(name, source, REAL, [(2.0,)])
    assert reply.stop is Stop.EXCEPTION
    assert re.fullmatch(told, reply.detail), reply.detail


def test_what_is_raised_is_shown_in_its_own_letters():
    source = "#include <stdexcept>\ndouble mirror_all(double) { throw std::logic_error(%s); }"
    (reply,) = called(
        "a.cpp", source % r'"caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \xe9 \xc3"', REAL, [(2.0,)]
    )
    assert reply.detail == "std::logic_error: café € 😀 é Ã"


@pytest.mark.parametrize(
    ("source", "told"),
    [
        ("function* mirrorAll(x) { yield x; }", "TypeError: mirrorAll is a GeneratorFunction: write it as"),
        ("const mirrorAll = async (x) => x;", "TypeError: mirrorAll is an AsyncFunction: write it as"),
    ],
)
def test_a_function_that_returns_no_answer_itself_is_told(source, told):
    (reply,) = called("a.js", source, REAL, [(2.0,)])
    assert reply.stop is Stop.EXCEPTION
    assert reply.detail.startswith(told)


ENDED = {  # a program that ends in its third line
    "a.c": "#undef NDEBUG\n#include <assert.h>\nint main(int x, char **words) { assert(x > 9); }",
    "a.go": "package main\nfunc main() {\n var a []int; print(a[len(a)]) }",
    "A.java": "class A {\n public static void main(String[] a) {\n  System.out.println(a[2]); } }",
    "a.js": "const fs = require('fs');\nlet a = null;\nconsole.log(a.b);",
    "a.rs": 'fn main() {\n let a: Option<i32> = None;\n println!("{}", a.unwrap()); }',
    "a.kt": "fun main() {\n val a = listOf<Int>()\n println(a.first()) }",
    "a.pypy": "def f():\n    # fails\n    return [][3]\nf()\n",
}


@pytest.mark.parametrize("name", daily(ENDED, ["a.js", "a.go"]))
def test_the_line_in_which_a_program_ends_is_told(name):
    done = ran(name, ENDED[name])
    assert (done.stop, done.detail[-9:]) == (Stop.EXITED, " (line 3)"), done


def test_a_line_that_the_file_has_not_is_none():
    source = "function mirrorAll(x) { throw Object.assign(Error('oh'), { stack: 'at solution.js:77' }); }"
    assert called("a.js", source, REAL, [(1.0,)])[0].detail == "Error: oh"
    program = "console.error('Error: oh at solution.js:77'); require('fs'); process.exit(1);"
    assert ran("a.js", program).detail == "exit status 1: Error: oh at solution.js:77"


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
    assert found[2].detail == f"std::out_of_range: {2**63} does not fit into long long"


# -- texts and truth values ---------------------------------------------------------

TEXTS = signature("(text, bool, [text], text?)", s="text", b="bool", items="[text; 0..9]", more="text?")
TURNED = sources("texts")
SIGNS = "".join(map(chr, range(32, 127)))
ROWS_OF_TEXTS = [
    ("", True, [], None),
    ("a", False, ["", "a b", "none"], "none"),
    (SIGNS, True, ['"', "\\", "\n", "=", "=61", "true", "1"], ""),
    ("ab" * 2000, False, [" "] * 9, "x\n"),
]


def word(text):
    return {"word": text}


@pytest.mark.parametrize("name", daily(TURNED, ["a.cpp", "a.js", "a.pypy"]))
def test_texts_and_truth_values_pass_unchanged(name):
    assert answers(name, TURNED[name], TEXTS, ROWS_OF_TEXTS) == [
        [word(s[::-1]), not b, [*map(word, items[::-1])], more if more is None else word(more)]
        for s, b, items, more in ROWS_OF_TEXTS
    ]


IN_C = {  # what is returned, the body, and what comes of it
    "text": ("const char *", 'return b ? s : "";', lambda s, b: word(s if b else "")),
    "bool": ("bool ", "return b;", lambda s, b: b),
    "bool?": ("bool ", "*out = b; return *s != 0;", lambda s, b: b if s else None),
    "text?": ("bool ", "*out = s; return b;", lambda s, b: word(s) if b else None),
}


@pytest.mark.parametrize("answer", IN_C)
def test_texts_and_truth_values_in_c(answer):
    kind, body, right = IN_C[answer]
    out = {"bool?": ", bool *out", "text?": ", const char **out"}.get(answer, "")
    source = f"#include <stdbool.h>\n{kind}mirror_all(const char *s, bool b{out}) {{ {body} }}"
    given = [(s, b) for s, b, *_ in ROWS_OF_TEXTS]
    found = answers("a.c", source, signature(answer, s="text", b="bool"), given)
    assert found == [right(*each) for each in given]


COUNTED = {
    "a.cpp": "bool mirror_all(double x) { return x > 1; }",
    "a.js": "const mirrorAll = x => x > 1;",
}


@pytest.mark.parametrize("name", COUNTED)
def test_a_count_that_is_returned_as_a_truth_value(name):
    """C++ makes an int of it; JavaScript tells them apart."""
    found = answers(name, COUNTED[name], signature("int", x="real"), [(1.0,), (2.0,)])
    assert found == ([0, 1] if name == "a.cpp" else [False, True])
    assert list(map(type, found)) == [int if name == "a.cpp" else bool] * 2


def test_a_text_beside_integers_of_any_size():
    given = signature("text", n="int", s="text")._replace(big=True)
    source = "std::string mirror_all(std::string n, std::string s) { return s + n; }"
    assert answers("a.cpp", source, given, [(10**30, ""), (12, "")]) == [word(str(10**30)), word("12")]


def test_a_text_that_is_too_long_is_told():
    source = "#include <string>\nstd::string mirror_all(double x) { return std::string(size_t(x), 'a'); }"
    whole, long = answers(
        "a.cpp", source, signature("text", x="real"), [(1e6,), (1000001.0,)], output_bytes=1 << 24
    )
    assert whole == word("a" * 10**6)
    assert long == {"type": "str", "text": "a text of 1,000,001 characters, more than 1,000,000"}


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
    assert deep[1].detail.endswith("stack overflow (line 2)")
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


def test_a_list_of_pairs_is_read_in_time_that_grows_with_its_length():
    """A hundred thousand of them took a JavaScript driver half a minute."""
    pairs = [(at, at) for at in range(100_000)]
    source = "function mirrorAll(xs) { return xs.length; }\n"
    with box_of("a.js", source, signature=signature("int", xs="[(int, int)]")) as box:
        done = box.call("mirror_all", [(pairs,)], LIMITS)
    assert [reply.answer for reply in done.replies] == [len(pairs)]
