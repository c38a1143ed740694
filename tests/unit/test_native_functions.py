"""Functions in other languages, called through drivers: every type, and every way to end a call."""

# ruff: noqa: E501 - sources in other languages

from __future__ import annotations

import re
from array import array

import pytest
from native import LIMITS, answers, box_of, called, signature
from sampling import daily, nightly

from judge.languages.draft import draft_of, driver_of
from judge.languages.model import language_called, languages
from judge.languages.shapes import Unsupported
from judge.sandbox import Stop
from judge.sandbox.calls import replies, text

pytestmark = pytest.mark.slow

REAL = signature("real", x="real")
FOUR = {"x": "real", "A": "point", "n": "int", "w": "word(left|right|throw|leave)"}
POINTS = signature("[vec2; 0..2]", **FOUR)  # all that there is in C
ALL = signature(
    "(real, [int], [vec2; 0..2], enclosure)?", **FOUR, items="[point; 0..9]", more="int?", raw="array(f64)"
)
# Each prints what an answer looks like, has a main of its own, and fails when it is told to throw or to leave.
EVERYTHING = {
    "a.c": """#include <stdio.h>
#include <stdlib.h>
int mirror_all(double x, Pt A, long long n, const char *w, Pt out[2]) {
    puts("[0,7]"); if (w[2] == 'a') abort();
    for (int i = 0; i < n; i++) { out[i].x = x * A.y; out[i].y = w[0] == 'l' ? A.x : -A.x; } return n; }
int main(void) { return 3; }""",
    "a.cpp": """#include <iostream>
#include <stdexcept>
std::optional<TupleRealListListEnclosure> mirror_all(double x, Pt A, long long n, std::string w,
        std::vector<Pt> items, std::optional<long long> more, std::vector<double> raw) {
    std::cout << "[0,7]\\n"; if (w == "throw") throw std::out_of_range("two"); if (w == "leave") *(volatile int *)8 = 1;
    if (!more) return {}; TupleRealListListEnclosure all; all.first = -x; all.fourth = {-x, x};
    for (double v : raw) all.second.push_back((long long)v + *more);
    for (auto& q : items) all.second.push_back((long long)q.x);
    all.third = std::vector<Pt>(n, Pt{x * A.y, w == "left" ? A.x : -A.x}); return all; }
int main() { return 3; }""",
    "a.go": """package main
import ("fmt"; "os")
func mirrorAll(x float64, A Pt, n int, w string, items []Pt, more *int, raw []float64) (all TupleRealListListEnclosure, ok bool) {
    fmt.Println("[0,7]"); if w == "throw" { panic("two") }; if w == "leave" { os.Exit(0) }
    if more == nil { return }; all.First, all.Fourth = -x, Enclosure{-x, x}
    for _, v := range raw { all.Second = append(all.Second, int(v) + *more) }
    for _, q := range items { all.Second = append(all.Second, int(q.X)) }
    for i := 0; i < n; i++ { p := Pt{x * A.Y, -A.X}; if w == "left" { p.Y = A.X }; all.Third = append(all.Third, p) }
    return all, true }
func main() { panic(1) }""",
    "Any.java": """import java.util.*;
public class Mine { static TupleRealListListEnclosure mirrorAll(double x, Pt A, long n, String w, List<Pt> items, Long more, double[] raw) {
    System.out.println("[0,7]"); if (w.equals("throw")) throw new RuntimeException("two"); if (w.equals("leave")) System.exit(3);
    if (more == null) return null; var second = new ArrayList<Long>(); var third = new ArrayList<Pt>();
    for (double v : raw) second.add((long) v + more);
    for (Pt q : items) second.add((long) q.x());
    while (n-- > 0) third.add(new Pt(x * A.y(), w.equals("left") ? A.x() : -A.x()));
    return new TupleRealListListEnclosure(-x, second, third, new Enclosure(-x, x)); }
    public static void main(String[] w) { System.exit(3); } }""",
    "a.rs": """fn mirror_all(x: f64, a: Pt, n: i64, w: String, items: Vec<Pt>, more: Option<i64>, raw: Vec<f64>) -> Option<TupleRealListListEnclosure> {
    println!("[0,7]"); if w == "throw" { panic!("two") } if w == "leave" { std::process::exit(4) }
    let m = more?; let mut second: Vec<i64> = raw.iter().map(|v| *v as i64 + m).collect();
    second.extend(items.iter().map(|q| q.x as i64));
    let third = (0..n).map(|_| Pt { x: x * a.y, y: if w == "left" { a.x } else { -a.x } }).collect();
    Some(TupleRealListListEnclosure { first: -x, second, third, fourth: Enclosure { lo: -x, hi: x } }) }
fn main() { panic!() }""",
    "a.js": """const mirrorAll = (x, A, n, w, items, more, raw) => {
    console.log('[0,7]'); if (w === 'throw') throw new Error('two'); if (w === 'leave') process.exit(0);
    return more === null ? null : { first: -x, second: [...Array.from(raw, v => v + more), ...items.map(q => Math.trunc(q.x))],
        third: Array.from({ length: n }, () => ({ x: x * A.y, y: w === 'left' ? A.x : -A.x })), fourth: { lo: -x, hi: x } }; };""",
    "a.pypy": """import os
def mirror_all(x, A, n, w, items, more, raw):
    print("[0,7]")
    if w == "throw": raise ValueError("two")
    if w == "leave": os._exit(5)
    if more is None: return None
    second = [int(v) + more for v in raw] + [int(q[0]) for q in items]
    return -x, second, [(x * A[1], A[0] if w == "left" else -A[0])] * n, (-x, x)
""",
}
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
SERIES = [[row(1.0), row(4.0)], [], [row(2.0)], [row(3.0), row(5.0)]]


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


def counted(box, monkeypatch):
    """The standard inputs of the processes that the box starts from now on."""
    given = []
    real = box.run_program

    def run(stdin, limits):
        given.append(stdin)
        return real(stdin, limits)

    monkeypatch.setattr(box, "run_program", run)
    return given


def test_many_series_are_answered_by_one_process(everything, monkeypatch):
    given = counted(everything.box, monkeypatch)
    told = []
    found = everything.box.call_series(
        "mirror_all", [everything.given(rows) for rows in SERIES], LIMITS, lambda: told.append(1)
    )
    assert [[reply.answer for reply in each.replies] for each in found] == [*map(everything.wanted, SERIES)]
    assert (len(given), len(told)) == (1, 3)


NUMBERS = [[(1.0,), (4.0,)], [], [(2.0,)], [(3.0,), (5.0,)]]


def test_where_one_of_them_fails_each_has_a_process_of_its_own(monkeypatch):
    source = "double mirror_all(double x) { if (x == 3) __builtin_trap(); return -x; }"
    with box_of("a.c", source, signature=REAL) as box:
        given = counted(box, monkeypatch)
        found = box.call_series("mirror_all", NUMBERS, LIMITS)
    assert [[reply.answer for reply in each.replies] for each in found] == [[-1, -4], [], [-2], [None]]
    assert found[-1].replies[0].stop is Stop.EXITED
    assert len(given) == 5  # all, two that are right, and the third twice to see at which call


def test_together_they_may_use_no_more_than_one_alone():
    source = "double mirror_all(double x) { for (volatile long i = 0; i < 20000000; i++); return -x; }"
    with box_of("a.c", source, signature=REAL) as box:
        limits = LIMITS._replace(cpu_seconds=0.8)
        found = box.call_series("mirror_all", [[(1.0,)]] * 40, limits)
    assert [each.replies[0].answer for each in found] == [-1] * 40


def test_a_call_without_end_is_the_one_to_blame():
    source = 'double mirror_all(double x) { while (x == 2) { __asm__(""); } return x; }'
    found = called("a.c", source, REAL, [(1.0,), (2.0,), (3.0,)], cpu_seconds=0.3)
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.CPU]


# -- functions as people write them ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "source",
    [
        "export function mirrorAll(x) { return -x; }",
        "export default function mirrorAll(x) { return -x; }",
        "const mirrorAll = x => -x;\nexport { mirrorAll };\n",
        "const mirrorAll = x => -x;\nmodule.exports = { mirrorAll };\n",
        "const all = 'src/*', some = /[\"'`/]/g;\nfunction mirrorAll(x) { return -x; }\nlet none = '*/';",
    ],
)
def test_what_a_script_exports_is_called_all_the_same(source):
    assert answers("a.mjs", source, REAL, [(2.5,)]) == [-2.5]


IMPORTING = """import fs, { readFileSync as slurp } from 'node:fs';
import * as path
  from "path";
import 'util';
const told = `
import nothing from 'nowhere';`;
export const mirrorAll = x => (console.log(path.sep, told, fs.constants), -x);
"""


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("a.mjs", f"\ufeff{IMPORTING}slurp(0);"),
        ("a.pypy", "def mirror_all(x):\n    return -x\nopen(0).read()\n"),
    ],
)
def test_what_reads_at_once_reads_nothing_and_the_function_is_called(name, source):
    assert answers(name, source, REAL, [(2.5,), (1.5,)]) == [-2.5, -1.5]


MIRROR = "static double mirrorAll(double x) { return -x; }"
JAVA = {
    "after others that speak of it": f'''class Pt {{ int x; }}
class B {{ String s = """\n  it is "so" {{{{ // \n  /* """; char c = '{{';
    static double twice(double x) {{ return A.mirrorAll(A.mirrorAll(x)); }} }}
class A {{ {MIRROR} }}''',
    "private, in a package": f"\ufeff/* mine */\r\npackage a.b;\npublic class A {{ private {MIRROR} }}",
    "not the public class": f"class A {{ {MIRROR} }}\npublic class B {{ }}",
    "an interface": f"interface A {{ {MIRROR} }}",
}


@pytest.mark.parametrize("where", daily(JAVA, ["after others that speak of it"]))
def test_java_functions_are_found_wherever_they_stand(where):
    assert answers("x.java", JAVA[where], REAL, [(2.5,)]) == [-2.5]


JAVA_OWN = [
    "class Pt { private final double x, y; Pt(double x, double y) { this.x = x; this.y = y; } }\nclass A { @ }",
    "class A { @ private static class Pt { double x; double y; Pt(double x, double y) { this.x = x; this.y = y; } } }",
    "class A { @ }\nrecord Pt(double x, double y) {}",
]


@pytest.mark.parametrize("own", daily(JAVA_OWN, JAVA_OWN[1:2]))
def test_java_points_of_ones_own_are_taken_wherever_they_stand(own):
    function = "static Pt mirrorAll(Pt A) { return new Pt(-A.x, -A.y); }"
    function = function if "record" not in own else function.replace("A.x", "A.x()").replace("A.y", "A.y()")
    assert answers("x.java", own.replace("@", function), signature("vec2", A="point"), [((1.0, 2.0),)]) == [
        [-1, -2]
    ]


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("source", "given", "calls", "found"),
    [
        (
            "class A { static float mirrorAll(double x) { return x < 0 ? Float.NaN : (float) x; } }",
            REAL,
            [(0.1,), (-1.0,)],
            [0.10000000149011612, {"type": "float", "text": "nan"}],
        ),
        (
            "class A { static byte[] mirrorAll(double[] raw) { byte[] out = new byte[raw.length]; for (int i = 0; i < raw.length; i++) out[i] = (byte) -raw[i]; return out; } }",
            signature("array(i8)", raw="array(f64)"),
            [(array("d", [1.0, -2.5]),), (array("d"),)],
            [[-1, 2], []],
        ),
        (
            "class A { record Enclosure(double lo, double hi) {} static Enclosure mirrorAll(double x) { return new Enclosure(-x, x); } }",
            signature("enclosure", x="real"),
            [(1.5,)],
            [[-1.5, 1.5]],
        ),
    ],
    ids=["float", "arrays", "a record of its own"],
)
def test_java_has_other_types_for_the_same(source, given, calls, found):
    assert answers("A.java", source, given, calls) == found


@pytest.mark.nightly
def test_what_java_cannot_begin_with_is_told_by_its_cause():
    source = 'class A { static double k = Double.parseDouble("x"); static double mirrorAll(double x) { return k; } }'
    found = called("A.java", source, REAL, [(1.0,)])
    assert found[0].detail == 'java.lang.NumberFormatException: For input string: "x"'


# -- integers of any length ------------------------------------------------------------------------------------

BIG = signature("int", n="int")._replace(big=True)
NEGATED = {
    "a.go": 'package main\nimport "math/big"\nfunc mirrorAll(n *big.Int) *big.Int { return n.Neg(n) }',
    "A.java": "import java.math.*;\nclass A { static BigInteger mirrorAll(BigInteger n) { return n.negate(); } }",
    "a.js": "function mirrorAll(n) { return -n; }",
    "a.pypy": "def mirror_all(n):\n    return -n\n",
    "a.cpp": 'std::string mirror_all(std::string n) { return "-" + n; }',
}


@pytest.mark.parametrize("name", daily(NEGATED, ["a.js", "a.go"]))
def test_integers_of_any_length_where_the_language_has_them(name):
    assert answers(name, NEGATED[name], BIG, [(10**40,), (7,)]) == [{"int": f"{-(10**40):x}"}, -7]


def test_a_function_may_take_them_as_numbers_of_the_machine_while_they_fit():
    source = "long long mirror_all(long long n) { return n / -2; }"
    calls = [(2**63 - 1,), (-(2**63),), (2**63,), (7,)]
    found = called("a.cpp", source, BIG, calls)
    assert [reply.answer for reply in found] == [-(2**62 - 1), 2**62, None, -3]
    assert found[2].detail == f"{2**63} does not fit into long long"


@pytest.mark.nightly
def test_of_points_too_and_in_128_bits():
    given = signature("int", A="integer-point")._replace(big=True)
    source = """struct IntPt { __int128 x, y; };
    int mirror_all(IntPt A) { return int(A.x >> 100) - int(A.y >> 100); }"""
    calls = [((5 << 100, -(3 << 100)),), ((-(2**127), 2**127),)]
    found = called("a.cpp", source, given, calls)
    assert [reply.answer for reply in found] == [8, None]
    source = "__int128 mirror_all(IntPt A) { return (__int128)std::stoll(A.x) * std::stoll(A.y); }"
    assert answers("a.cpp", source, given, [((-(10**12), 10**12),), ((0, 5),)]) == [
        {"int": f"{-(10**24):x}"},
        0,
    ]
    assert "does not fit into __int128" in found[1].detail


@pytest.mark.nightly
def test_a_struct_of_ones_own_may_hold_smaller_numbers_which_overflow_without_a_crash():
    given = signature("integer-point", A="integer-point", B="point")
    source = """struct IntPt { int x, y; };
    struct Pt { float x, y; };
    IntPt mirror_all(IntPt A, Pt B) { return {-A.y * A.y, int(B.x * B.y)}; }
    int main() { IntPt A = {3, 4}; mirror_all(A, {}); }"""
    calls = [((3, 4), (2.5, 4.0)), ((3, 90000), (1.0, 1.0))]
    assert answers("a.cpp", source, given, calls) == [[-16, 10], [2 * 2**32 - 8100000000, 1]]


def test_in_c_they_are_digits():
    source = """#include <string.h>
    long long mirror_all(const char *n) { return n[0] == '-' ? -(long long)strlen(n + 1) : (long long)strlen(n); }"""
    assert answers("a.c", source, BIG, [(10**40,), (-(10**20),), (7,)]) == [41, -21, 1]


def test_in_c_an_enclosure_is_a_struct():
    source = "Enclosure mirror_all(double x) { return (Enclosure){-x, x}; }"
    assert answers("a.c", source, signature("enclosure", x="real"), [(1.5,)]) == [[-1.5, 1.5]]


# -- what stands around the function ---------------------------------------------------------------------------

MEDDLING = {  # macros, pragmas and names that files of contests begin with
    "a.c": """#define int long long
#define in stdin
#define out stdout
#define out_of(x) x
double mirror_all(double x) { int y = 1; return -x * y; }
""",
    "a.cpp": """#pragma GCC optimize("Ofast")
#include <bits/stdc++.h>
#define int long long
#define double long double
#define out cout
#define put(x) cout << x
#define text 7
#define at(i) [i]
using namespace std;
typedef vector<int> vi;
static int early = (cout << "[0,7]" << endl, 0);
double mirror_all(double x) { put(x); return x == 3 ? sqrtl(-x) : -x; }
signed main() { cin >> early; }
""",
}


def test_macros_of_ones_own_do_not_reach_the_driver():
    assert answers("a.c", MEDDLING["a.c"], REAL, [(1.0,), (2.5,)]) == [-1, -2.5]


@pytest.mark.nightly
def test_nor_do_those_of_cpp_nor_does_fast_mathematics_which_has_no_nan():
    *plain, nan = answers("a.cpp", MEDDLING["a.cpp"], REAL, [(1.0,), (2.5,), (3.0,)])
    assert (plain, nan) == ([-1, -2.5], {"type": "float", "text": "nan"})


CPP = [
    "static inline auto mirror_all(double x) noexcept -> double\n{ return -x; }",
    "const auto mirror_all = [](double x) { return -x; };",
    "template <class T> T mirror_all(T x) { return -x; }",
    "#include <cmath>\ndouble mirror_all(double x) { return x < 0 ? std::sqrt(x) : -x; }",
]


@pytest.mark.parametrize("source", daily(CPP, CPP[3:]))
def test_a_function_may_be_defined_in_any_way_of_cpp(source):
    assert answers("a.cpp", source, REAL, [(1.5,)]) == [-1.5]
    if "sqrt" in source:
        assert answers("a.cpp", source, REAL, [(-1.0,)]) == [{"type": "float", "text": "nan"}]


UNLIKE = [
    ("a.cpp", "int mirror_all(int a, int b) { return a; }", "double mirror_all(double x)"),
    ("a.c", "double mirror_all(double *x) { return *x; }", "double mirror_all(double x)"),
    ("a.go", "package main\nfunc mirrorAll(a string) int { return 1 }", "func mirrorAll(x float64) float64"),
    (
        "A.java",
        "class A { static double mirrorAll(String a) { return 1; } }",
        "static double mirrorAll(double x)",
    ),
    ("a.rs", "fn mirror_all(a: &str) -> f64 { 1.0 }", "fn mirror_all(x: f64) -> f64"),
]


@pytest.mark.parametrize(
    ("name", "source", "words"), [each if each[0] in ("a.c", "a.go") else nightly(*each) for each in UNLIKE]
)
def test_another_declaration_is_told_as_the_problem_has_it(name, source, words):
    with box_of(name, source, signature=REAL) as box:
        assert box.inspect().fault.message.endswith(f"is not declared as the problem says: {words}")


@pytest.mark.parametrize(
    ("given", "source", "words"),
    [
        (BIG, "long long mirror_all(long long n) { return n; }", "mirror_all(const char *n)"),
        (signature("real?", x="real"), "bool mirror_all(double x, float *out) { return 0; }", "double *out)"),
        (
            signature("[int]", n="int"),
            "int mirror_all(int n) { return n; }",
            "C functions of this problem's types cannot be called: give it a main",
        ),
    ],
)
def test_in_c_no_pointer_and_no_type_is_taken_for_something_else(given, source, words):
    with box_of("a.c", source, signature=given) as box:
        assert box.inspect().fault.message.endswith(words)


@pytest.mark.parametrize(
    ("name", "source", "place", "words"),
    [
        ("a.js", "function mirrorAll(x) {\n  return 1 +;\n}", (2, 13), "SyntaxError: Unexpected token ';'"),
        ("a.mjs", f"{IMPORTING}slurp(0;", (8, 7), "SyntaxError"),
        ("a.pypy", "def mirror_all(x):\n    return 1 +\n", (2, 0), "SyntaxError"),
        ("a.cpp", "double mirror_all(double x) {\n  return y;\n}", (2, 10), ""),
    ],
)
def test_an_error_is_told_before_it_is_called_and_keeps_its_place(name, source, place, words):
    with box_of(name, source, signature=REAL) as box:
        fault = box.inspect().fault
    assert fault.message.startswith(words)
    assert (fault.line, fault.column) == place


@pytest.mark.parametrize(
    ("name", "source", "words"),
    [
        (
            "a.cpp",
            "double mirrorAll(double x) { return x; }",
            "neither mirror_all nor main: write mirror_all for mirrorAll",
        ),
        (
            "a.go",
            "package main\nfunc mirror_all(x float64) {}",
            "neither mirrorAll nor main: write mirrorAll for mirror_all",
        ),
        ("a.c", "int other(void) { return 1; }", "neither mirror_all nor main"),
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
        ("a.c", "// double mirror_all(double x) { return x; }\nint a;", "neither mirror_all nor main"),
    ],
)
def test_neither_function_nor_program_is_told(name, source, words):
    with box_of(name, source, signature=REAL) as box:
        assert box.inspect().fault.message.endswith(words)


# -- what goes between ----------------------------------------------------------------------------------------


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


@pytest.mark.parametrize("language", [each for each in languages() if each.defines], ids=lambda each: each.id)
def test_a_declaration_is_met_by_what_the_language_looks_for(language):
    draft = draft_of(language, POINTS)
    head = driver_of(language).declared(draft)
    pattern = language.defines.replace("{entry}", draft.entry)
    assert re.search(pattern, f"{head} {{" if language.id != "pypy" else head)


@pytest.mark.parametrize("name", daily(["c", "cpp", "rust"], ["c"]))
def test_a_stub_says_that_numbers_are_digits(name):
    language = language_called(name)
    maker, draft = driver_of(language), draft_of(language, BIG)
    before, body = maker.frame(draft, "still to be written")
    assert "// An int of any size comes as the text of its digits" in before
    source = f"{before}\n{maker.declared(draft)}{body}\n"
    with box_of(f"a{language.suffixes[0]}", source, signature=BIG) as box:
        assert box.inspect().fault is None


def test_c_has_no_form_for_a_list_without_an_end():
    with pytest.raises(Unsupported):
        driver_of(language_called("c")).driver(draft_of(language_called("c"), signature("[int]", x="int")))
