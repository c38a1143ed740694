"""Functions in other languages, called through drivers: every type, and every way to end a call."""

# ruff: noqa: E501 - sources in other languages

from __future__ import annotations

import re
from array import array

import pytest
from native import LIMITS, answers, box_of, called, signature

from judge.languages.draft import draft_of, driver_of
from judge.languages.model import language_called, languages
from judge.languages.shapes import Unsupported
from judge.sandbox import Stop
from judge.sandbox.calls import replies, text

pytestmark = pytest.mark.slow


REAL = signature("real", x="real")
REALS = {
    "a.c": "double mirror_all(double x) { return -x; }",
    "a.cpp": "double mirror_all(double x) { return -x; }",
    "a.go": "package main\nfunc mirrorAll(x float64) float64 { return -x }",
    "A.java": "class A { static double mirrorAll(double x) { return -x; } }",
    "a.rs": "fn mirror_all(x: f64) -> f64 { -x }",
    "a.js": "function mirrorAll(x) { return -x; }",
    "a.pypy": "def mirror_all(x):\n    return -x\n",
}


@pytest.mark.parametrize("name", REALS)
def test_reals_pass_unchanged(name):
    values = [0.1, 1e-308, 1.7976931348623157e308, 5e-324, 12345678901234.5, 3, -2.5]
    assert answers(name, REALS[name], REAL, [(value,) for value in values]) == [-value for value in values]


POINTS = signature("[vec2; 0..2]", r="real", A="point", n="int", w="word(left|right)")
MIXED = {
    "a.c": """int mirror_all(double r, Pt A, long long n, const char *w, Pt out[2]) {
    for (int i = 0; i < n; i++) { out[i].x = r * A.y; out[i].y = w[0] == 'l' ? A.x : -A.x; } return n; }""",
    "a.cpp": """std::vector<Pt> mirror_all(double r, Pt A, long long n, std::string w) {
    return std::vector<Pt>(n, Pt{r * A.y, w == "left" ? A.x : -A.x}); }""",
    "a.go": """package main
func mirrorAll(r float64, A Pt, n int, w string) (out []Pt) {
    for i := 0; i < n; i++ { if w == "left" { out = append(out, Pt{r * A.Y, A.X}) } else {
    out = append(out, Pt{r * A.Y, -A.X}) } }; return }""",
    "Any.java": """import java.util.*;
class Mine { static List<Pt> mirrorAll(double r, Pt A, long n, String w) {
    var out = new ArrayList<Pt>(); while (n-- > 0) out.add(new Pt(r * A.y(), w.equals("left") ? A.x() : -A.x()));
    return out; } }""",
    "a.rs": """fn mirror_all(r: f64, a: Pt, n: i64, w: String) -> Vec<Pt> {
    (0..n).map(|_| Pt { x: r * a.y, y: if w == "left" { a.x } else { -a.x } }).collect() }""",
    "a.js": """const mirrorAll = (r, A, n, w) =>
    Array.from({ length: n }, () => ({ x: r * A.y, y: w === 'left' ? A.x : -A.x }));""",
    "a.pypy": """def mirror_all(r, A, n, w):
    return [(r * A[1], A[0] if w == "left" else -A[0])] * n
""",
}


@pytest.mark.parametrize("name", MIXED)
def test_points_ints_and_words(name):
    calls = [(2.0, (1.5, 4), 2, "left"), (1, (1.25, 8.0), 1, "right"), (1, (0, 0), 0, "left")]
    found = answers(name, MIXED[name], POINTS, calls)
    assert found == [[[8, 1.5], [8, 1.5]], [[8, -1.25]], []]


LISTS = signature("(real, [int])?", items="[point; 0..9]", more="int?", raw="array(f64)")
NESTED = {
    "a.cpp": """std::optional<PairRealList> mirror_all(std::vector<Pt> items, std::optional<long long> more,
    std::vector<double> raw) { if (!more) return {}; PairRealList p; p.first = 0; for (auto& q : items) p.first += q.x;
    for (double v : raw) p.second.push_back((long long)v + *more); return p; }""",
    "a.go": """package main
func mirrorAll(items []Pt, more *int, raw []float64) (p PairRealList, ok bool) {
    if more == nil { return }
    for _, q := range items { p.First += q.X }
    for _, v := range raw { p.Second = append(p.Second, int(v) + *more) }
    return p, true }""",
    "A.java": """import java.util.*;
class A { static PairRealList mirrorAll(List<Pt> items, Long more, double[] raw) {
    if (more == null) return null; double sum = 0; for (Pt q : items) sum += q.x();
    var out = new ArrayList<Long>(); for (double v : raw) out.add((long) v + more); return new PairRealList(sum, out); } }""",
    "a.rs": """fn mirror_all(items: Vec<Pt>, more: Option<i64>, raw: Vec<f64>) -> Option<PairRealList> {
    let m = more?; Some(PairRealList { first: items.iter().map(|q| q.x).sum::<f64>() + 0.0,
    second: raw.iter().map(|v| *v as i64 + m).collect() }) }""",
    "a.js": """function mirrorAll(items, more, raw) { if (more === null) return null;
    return { first: items.reduce((s, q) => s + q.x, 0), second: raw.map(v => v + more) }; }""",
    "a.pypy": """def mirror_all(items, more, raw):
    return None if more is None else (sum(q[0] for q in items), [int(v) + more for v in raw])
""",
}


@pytest.mark.parametrize("name", NESTED)
def test_lists_tuples_and_what_is_not_there(name):
    calls = [
        ([(1.5, 2.0), (2.0, 3.0)], 4, array("d", [1.0, 2.0])),
        ([], -1, array("d")),
        ([(1.0, 1.0)], None, array("d", [1.0])),
    ]
    assert answers(name, NESTED[name], LISTS, calls) == [[3.5, [5, 6]], [0, []], None]


@pytest.mark.parametrize(
    ("name", "source", "words", "place"),
    [
        ("a.js", "function mirrorAll(x) {\n  return 1 +;\n}", "SyntaxError: Unexpected token ';'", (2, 13)),
        ("a.pypy", "def mirror_all(x):\n    return 1 +\n", "SyntaxError", (2, 0)),
    ],
)
def test_a_script_that_does_not_parse_is_told_before_it_is_called(name, source, words, place):
    with box_of(name, source, signature=REAL) as box:
        fault = box.inspect().fault
    assert fault.message.startswith(words)
    assert (fault.line, fault.column) == place


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


def test_what_is_imported_keeps_the_lines():
    with box_of("a.mjs", f"{IMPORTING}slurp(0;", signature=REAL) as box:
        assert box.inspect().fault.line == 8


JAVA = {
    "another class first": "class Pt { int x; }\nclass A { static double mirrorAll(double x) { return -x; } }",
    "called before": "class B { static double twice(double x) { return A.mirrorAll(A.mirrorAll(x)); } }\nclass A { static double mirrorAll(double x) { return -x; } }",
    "not the public class": "class A { static double mirrorAll(double x) { return -x; } }\npublic class B { }",
    "an interface": "interface A { static double mirrorAll(double x) { return -x; } }",
    "private": "class A { private static double mirrorAll(double x) { return -x; } }",
    "in a package": "/* mine */\npackage a.b;\npublic class A { static double mirrorAll(double x) { return -x; } }",
    "a text block": 'class B { String s = """\n  it is "so" {{ // \n  /* """; }\nclass A { static double mirrorAll(double x) { return -x; } }',
    "a mark of its bytes' order": "\ufeffpackage a;\r\nclass A { static double mirrorAll(double x) { return -x; } }",
    "a brace that is a character": "class B { char c = '{'; }\nclass A { static double mirrorAll(double x) { return -x; } }",
}


@pytest.mark.parametrize("source", JAVA.values(), ids=JAVA)
def test_java_functions_are_found_wherever_they_stand(source):
    assert answers("x.java", source, REAL, [(2.5,)]) == [-2.5]


@pytest.mark.parametrize(
    "own",
    [
        "class Pt { private final double x, y; Pt(double x, double y) { this.x = x; this.y = y; } }\nclass A { @ }",
        "class A { @ private static class Pt { double x; double y; Pt(double x, double y) { this.x = x; this.y = y; } } }",
        "class A { @ }\nrecord Pt(double x, double y) {}",
    ],
)
def test_java_points_of_ones_own_are_taken_wherever_they_stand(own):
    function = "static Pt mirrorAll(Pt A) { return new Pt(-A.x, -A.y); }"
    function = function if "record" not in own else function.replace("A.x", "A.x()").replace("A.y", "A.y()")
    assert answers("x.java", own.replace("@", function), signature("vec2", A="point"), [((1.0, 2.0),)]) == [
        [-1, -2]
    ]


def test_a_java_float_is_the_number_that_it_is():
    source = "class A { static float mirrorAll(double x) { return x < 0 ? Float.NaN : (float) x; } }"
    found = answers("A.java", source, REAL, [(0.1,), (-1.0,)])
    assert found == [0.10000000149011612, {"type": "float", "text": "nan"}]


def test_what_java_cannot_begin_with_is_told_by_its_cause():
    source = 'class A { static double k = Double.parseDouble("x"); static double mirrorAll(double x) { return k; } }'
    found = called("A.java", source, REAL, [(1.0,)])
    assert found[0].detail == 'java.lang.NumberFormatException: For input string: "x"'


def test_java_has_arrays_of_numbers_for_arrays():
    source = "class A { static byte[] mirrorAll(double[] raw) { byte[] out = new byte[raw.length]; for (int i = 0; i < raw.length; i++) out[i] = (byte) -raw[i]; return out; } }"
    given = signature("array(i8)", raw="array(f64)")
    assert answers("A.java", source, given, [(array("d", [1.0, -2.5]),), (array("d"),)]) == [[-1, 2], []]


BOUNDS = signature("enclosure", x="real")


@pytest.mark.parametrize(
    ("name", "source"),
    [
        (
            "A.java",
            "class A { record Enclosure(double lo, double hi) {} static Enclosure mirrorAll(double x) { return new Enclosure(-x, x); } }",
        ),
        ("a.js", "const mirrorAll = x => ({ lo: -x, hi: x });"),
    ],
)
def test_an_enclosure_has_two_bounds(name, source):
    assert answers(name, source, BOUNDS, [(1.5,)]) == [[-1.5, 1.5]]


BIG = signature("int", n="int")._replace(big=True)


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("a.go", 'package main\nimport "math/big"\nfunc mirrorAll(n *big.Int) *big.Int { return n.Neg(n) }'),
        (
            "A.java",
            "import java.math.*;\nclass A { static BigInteger mirrorAll(BigInteger n) { return n.negate(); } }",
        ),
        ("a.js", "function mirrorAll(n) { return -n; }"),
        ("a.pypy", "def mirror_all(n):\n    return -n\n"),
        ("a.cpp", 'std::string mirror_all(std::string n) { return "-" + n; }'),
    ],
)
def test_integers_of_any_length_where_the_language_has_them(name, source):
    assert answers(name, source, BIG, [(10**40,), (7,)]) == [{"int": f"{-(10**40):x}"}, -7]


def test_a_function_may_take_them_as_numbers_of_the_machine_while_they_fit():
    source = "long long mirror_all(long long n) { return n / -2; }"
    calls = [(2**63 - 1,), (-(2**63),), (2**63,), (7,)]
    found = called("a.cpp", source, BIG, calls)
    assert [reply.answer for reply in found] == [-(2**62 - 1), 2**62, None, -3]
    assert found[2].detail == f"{2**63} does not fit into long long"


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


def test_a_struct_of_ones_own_may_hold_smaller_numbers():
    given = signature("integer-point", A="integer-point", B="point")
    source = """struct IntPt { int x, y; };
    struct Pt { float x, y; };
    IntPt mirror_all(IntPt A, Pt B) { return {-A.y, int(B.x * B.y)}; }"""
    assert answers("a.cpp", source, given, [((3, 4), (2.5, 4.0))]) == [[-4, 10]]


def test_an_overflow_is_an_answer_and_no_crash_of_the_driver():
    given = signature("int", A="integer-point")
    source = """struct IntPt { int x, y; };
    int mirror_all(IntPt A) { return A.x * A.x + A.y * A.y; }
    int main() { IntPt A = {3, 4}; mirror_all(A); }"""
    assert answers("a.cpp", source, given, [((90000, 0),), ((3, 4),)]) == [8100000000 - 2 * 2**32, 25]


def test_in_c_they_are_digits():
    source = """#include <string.h>
    long long mirror_all(const char *n) { return n[0] == '-' ? -(long long)strlen(n + 1) : (long long)strlen(n); }"""
    assert answers("a.c", source, BIG, [(10**40,), (-(10**20),), (7,)]) == [41, -21, 1]


def test_a_type_that_a_language_has_no_form_of_asks_for_a_main():
    given = signature("[int]", n="int")
    with box_of("a.c", "int mirror_all(int n) { return n; }", signature=given) as box:
        assert box.inspect().fault.message == (
            "C functions of this problem's types cannot be called: give it a main"
        )


ENCLOSURE = signature("enclosure", x="real")


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("a.c", "Enclosure mirror_all(double x) { return (Enclosure){-x, x}; }"),
        ("a.cpp", "Enclosure mirror_all(double x) { return {-x, x}; }"),
        ("a.go", "package main\nfunc mirrorAll(x float64) Enclosure { return Enclosure{-x, x} }"),
        ("A.java", "class A { static Enclosure mirrorAll(double x) { return new Enclosure(-x, x); } }"),
        ("a.rs", "fn mirror_all(x: f64) -> Enclosure { Enclosure { lo: -x, hi: x } }"),
        ("a.js", "function mirrorAll(x) { return { lo: -x, hi: x }; }"),
        ("a.pypy", "def mirror_all(x):\n    return -x, x\n"),
    ],
)
def test_an_enclosure_is_a_pair(name, source):
    assert answers(name, source, ENCLOSURE, [(1.5,), (0.25,)]) == [[-1.5, 1.5], [-0.25, 0.25]]


RAISING = {  # the second call fails, the others do not
    "a.cpp": '#include <stdexcept>\ndouble mirror_all(double x) { if (x == 2) throw std::out_of_range("two"); return x; }',
    "a.go": 'package main\nfunc mirrorAll(x float64) float64 { if x == 2 { panic("two") }; return x }',
    "A.java": 'class A { static double mirrorAll(double x) { if (x == 2) throw new RuntimeException("two"); return x; } }',
    "a.rs": 'fn mirror_all(x: f64) -> f64 { if x == 2.0 { panic!("two") } x }',
    "a.js": "function mirrorAll(x) { if (x === 2) throw new Error('two'); return x; }",
    "a.pypy": 'def mirror_all(x):\n    if x == 2:\n        raise ValueError("two")\n    return x\n',
}


@pytest.mark.parametrize("name", RAISING)
def test_what_is_raised_costs_its_own_call(name):
    found = called(name, RAISING[name], REAL, [(1.0,), (2.0,), (3.0,)])
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.EXCEPTION, Stop.ANSWERED]
    assert "two" in found[1].detail


ENDING = {
    "a.c": ("#include <stdlib.h>\ndouble mirror_all(double x) { if (x == 2) abort(); return x; }", "SIGABRT"),
    "a.cpp": ("double mirror_all(double x) { if (x == 2) *(volatile int *)8 = 1; return x; }", "SIGSEGV"),
    "a.go": (
        'package main\nimport "os"\nfunc mirrorAll(x float64) float64 { if x == 2 { os.Exit(0) }; return x }',
        "mid-call",
    ),
    "A.java": (
        "class A { static double mirrorAll(double x) { if (x == 2) System.exit(3); return x; } }",
        "status 3",
    ),
    "a.js": ("function mirrorAll(x) { if (x === 2) process.exit(0); return x; }", "mid-call"),
}


@pytest.mark.parametrize("name", ENDING)
def test_the_call_that_ends_the_process_is_the_one_to_blame(name):
    source, words = ENDING[name]
    found = called(name, source, REAL, [(1.0,), (2.0,), (3.0,)])
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.EXITED]
    assert words in found[1].detail


def test_a_call_without_end_is_the_one_to_blame():
    source = 'double mirror_all(double x) { while (x == 2) { __asm__(""); } return x; }'
    found = called("a.c", source, REAL, [(1.0,), (2.0,), (3.0,)], cpu_seconds=0.3)
    assert [reply.stop for reply in found] == [Stop.ANSWERED, Stop.CPU]


PRINTING = {
    "a.c": '#include <stdio.h>\ndouble mirror_all(double x) { puts("[0,7]"); return x; }\nint main(void) { return 3; }',
    "a.cpp": '#include <iostream>\nstruct Pt { double x, y; };\ndouble mirror_all(double x) { std::cout << "[0,7]\\n"; return x; }\nint main() { return 3; }',
    "a.go": 'package main\nimport "fmt"\ntype Pt struct{ X, Y float64 }\nfunc mirrorAll(x float64) float64 { fmt.Println("[0,7]"); return x }\nfunc main() { panic(1) }',
    "Mine.java": 'public class Mine { record Pt(double x, double y) {} static double mirrorAll(double x) { System.out.println("[0,7]"); return x; } public static void main(String[] w) { System.exit(3); } }',
    "a.rs": 'struct Pt { x: f64, y: f64 }\nfn mirror_all(x: f64) -> f64 { println!("[0,7]"); x }\nfn main() { panic!() }',
    "a.js": "function mirrorAll(x) { console.log('[0,7]'); return x; }",
}


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


@pytest.mark.parametrize("name", MEDDLING)
def test_macros_and_pragmas_of_ones_own_do_not_reach_the_driver(name):
    assert answers(name, MEDDLING[name], REAL, [(1.0,), (2.5,)]) == [-1, -2.5]


def test_not_a_number_is_told_under_fast_mathematics_too():
    assert answers("a.cpp", MEDDLING["a.cpp"], REAL, [(3.0,)])[0]["type"] == "float"


@pytest.mark.parametrize("name", PRINTING)
def test_prints_a_main_and_types_of_ones_own_do_no_harm(name):
    assert answers(name, PRINTING[name], REAL, [(1.0,), (2.5,)]) == [1, 2.5]


@pytest.mark.parametrize(
    ("name", "source", "words"),
    [
        ("a.cpp", "int mirror_all(int a, int b) { return a; }", "double mirror_all(double x)"),
        ("a.c", "double mirror_all(double *x) { return *x; }", "double mirror_all(double x)"),
        (
            "a.go",
            "package main\nfunc mirrorAll(a string) int { return 1 }",
            "func mirrorAll(x float64) float64",
        ),
        (
            "A.java",
            "class A { static double mirrorAll(String a) { return 1; } }",
            "static double mirrorAll(double x)",
        ),
        ("a.rs", "fn mirror_all(a: &str) -> f64 { 1.0 }", "fn mirror_all(x: f64) -> f64"),
    ],
)
def test_another_declaration_is_told_as_the_problem_has_it(name, source, words):
    with box_of(name, source, signature=REAL) as box:
        assert box.inspect().fault.message.endswith(f"is not declared as the problem says: {words}")


@pytest.mark.parametrize(
    ("given", "source", "words"),
    [
        (BIG, "long long mirror_all(long long n) { return n; }", "mirror_all(const char *n)"),
        (signature("real?", x="real"), "bool mirror_all(double x, float *out) { return 0; }", "double *out)"),
    ],
)
def test_in_c_no_pointer_is_taken_for_something_else(given, source, words):
    with box_of("a.c", source, signature=given) as box:
        assert box.inspect().fault.message.endswith(words)


@pytest.mark.parametrize(
    "source",
    [
        "static inline auto mirror_all(double x) noexcept -> double\n{ return -x; }",
        "const auto mirror_all = [](double x) { return -x; };",
        "template <class T> T mirror_all(T x) { return -x; }",
    ],
)
def test_a_function_may_be_defined_in_any_way_of_cpp(source):
    assert answers("a.cpp", source, REAL, [(1.5,)]) == [-1.5]


def test_an_error_of_its_own_keeps_its_line_in_function_mode():
    with box_of("a.cpp", "double mirror_all(double x) {\n  return y;\n}", signature=REAL) as box:
        assert box.inspect().fault[1:3] == (2, 10)


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


def test_not_a_number_is_told_as_in_python():
    found = answers(
        "a.cpp", "#include <cmath>\ndouble mirror_all(double x) { return std::sqrt(-x); }", REAL, [(1.0,)]
    )
    assert found == [{"type": "float", "text": "nan"}]


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
    assert re.search(
        language.head("mirror_all"),
        head + (" {" if language.id in ("c", "cpp", "java", "go", "rust", "javascript") else ""),
    )


@pytest.mark.parametrize("name", ["c", "cpp", "rust"])
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


def counted(box, monkeypatch):
    """The standard inputs of the processes that the box starts from now on."""
    given = []
    real = box.run_program

    def run(stdin, limits):
        given.append(stdin)
        return real(stdin, limits)

    monkeypatch.setattr(box, "run_program", run)
    return given


SERIES = [[(1.0,), (4.0,)], [], [(2.0,)], [(3.0,), (5.0,)]]


@pytest.mark.parametrize("name", ["a.c", "a.go", "A.java", "a.js", "a.rs", "a.cpp", "a.pypy"])
def test_many_series_are_answered_by_one_process(name, monkeypatch):
    with box_of(name, REALS[name], signature=REAL) as box:
        given = counted(box, monkeypatch)
        told = []
        found = box.call_series("mirror_all", SERIES, LIMITS, lambda: told.append(1))
    assert [[reply.answer for reply in each.replies] for each in found] == [[-1, -4], [], [-2], [-3, -5]]
    assert (len(given), len(told)) == (1, 3)


def test_where_one_of_them_fails_each_has_a_process_of_its_own(monkeypatch):
    source = "double mirror_all(double x) { if (x == 3) __builtin_trap(); return -x; }"
    with box_of("a.c", source, signature=REAL) as box:
        given = counted(box, monkeypatch)
        found = box.call_series("mirror_all", SERIES, LIMITS)
    assert [[reply.answer for reply in each.replies] for each in found] == [[-1, -4], [], [-2], [None]]
    assert found[-1].replies[0].stop is Stop.EXITED
    assert len(given) == 5  # all, two that are right, and the third twice to see at which call


def test_together_they_may_use_no_more_than_one_alone():
    source = "double mirror_all(double x) { for (volatile long i = 0; i < 20000000; i++); return -x; }"
    with box_of("a.c", source, signature=REAL) as box:
        limits = LIMITS._replace(cpu_seconds=0.8)
        found = box.call_series("mirror_all", [[(1.0,)]] * 40, limits)
    assert [each.replies[0].answer for each in found] == [-1] * 40
