"""Functions in Go, Rust and PyPy as people write them: names and types of their own, and how they end."""

from __future__ import annotations

import pytest
from native import LIMITS, answers, box_of, called, need, signature
from sampling import daily

from judge.languages.boxes import AnyBoxes
from judge.languages.draft import draft_of, driver_of
from judge.languages.model import language_called
from judge.sandbox import Boxes, Stop
from judge.values.grammar import parse

pytestmark = pytest.mark.slow

REAL = signature("real", x="real")
BIG = signature("int", n="int")._replace(big=True)
RUST_WHOLE = {
    "digits": "fn mirror_all(n: String) -> i64 { n.len() as i64 }",
    "machine": "fn mirror_all(n: i128) -> i128 { n >> 100 }",
}


@pytest.mark.nightly
def test_in_rust_they_are_digits_or_what_the_function_takes_and_never_within_an_answer():
    assert answers("a.rs", RUST_WHOLE["digits"], BIG, [(10**40,), (-7,)]) == [41, 2]
    found = called("a.rs", RUST_WHOLE["machine"], BIG, [(5 << 100,), (1 << 127,), (-(1 << 127),)])
    assert [reply.answer for reply in found] == [5, None, -(1 << 27)]
    assert found[1].detail == f"{1 << 127} does not fit into i128"
    with box_of("a.rs", RUST_WHOLE["digits"], signature=BIG._replace(answer=parse("[int]"))) as box:
        told = box.inspect().fault.message
    assert told == "Rust functions of this problem's types cannot be called: give it a main"


def test_in_go_an_answer_may_be_one_too():
    counting = 'package main\nimport "math/big"\nfunc mirrorAll(n *big.Int) int { return n.BitLen() }'
    assert answers("a.go", counting, BIG, [(2**99,)]) == [100]
    nothing = 'package main\nimport "math/big"\nfunc mirrorAll(n *big.Int) *big.Int { return nil }'
    assert answers("a.go", nothing, BIG, [(2**99,)]) == [None]


def test_go_says_a_type_once_for_neighbours_and_takes_big_ints_by_their_address():
    go, given = language_called("go"), signature("real", r="real", A="point", B="point", n="int")
    declared = [driver_of(go).declared(draft_of(go, each)) for each in (BIG, given)]
    assert declared == ["func mirrorAll(n *big.Int) int", "func mirrorAll(r float64, A, B Pt, n int) float64"]


def test_a_stack_without_end_and_more_memory_than_there_is_are_said_so():
    source = """package main
func deep(x float64) float64 { return deep(x) + 1 }
func mirrorAll(x float64) float64 {
    if x == 2 { return deep(x) }
    if x == 4 { all := make([]float64, 1<<33); all[5] = x; return all[int(x)] }
    return x }"""
    with box_of("a.go", source, signature=REAL) as box:
        deep, large = (
            box.call_many("mirror_all", [(1.0,), (x,), (3.0,)], LIMITS).replies for x in (2.0, 4.0)
        )
    assert [reply.stop for reply in deep] == [Stop.ANSWERED, Stop.EXITED]
    assert deep[1].detail.endswith("stack overflow")
    assert [reply.stop for reply in large] == [Stop.ANSWERED, Stop.MEMORY]


def test_pypy_prints_nothing_of_its_own():
    with box_of("a.pypy", "def mirror_all(x):\n    return -x\n", signature=REAL) as box:
        assert box.inspect().fault is None
        assert box.call_many("mirror_all", [(1.0,)], LIMITS).printed == b""


PLACED = signature("[point; 0..2]", A="point")
OWN = {  # types, fields and names of the submission's own, as people have them
    "lower.go": """package main
type Pt struct{ x, y float64 }
func mirrorAll(A Pt) []Pt { return []Pt{{A.y, A.x}} }""",
    "grouped.go": """package geometry // a package of any name
type (
	Pt struct {
		U float64 `json:"u"` // along
		V float64
	}
)
func mirrorAll(A Pt) []Pt { return []Pt{{A.V, A.U}} }""",
    "printer.go": """package main
import ("bufio"; "fmt"; "os")
var out = bufio.NewWriter(os.Stdout) // made before the driver begins
func math() string { return `func main() {} // "` }
func mirrorAll(A Pt) []Pt { fmt.Fprintln(out, "[0,[]]", math()); out.Flush(); return []Pt{{A.Y, A.X}} }""",
    "fields.rs": """\ufeff//! My solution.
#![allow(dead_code,
    unused)]
#[derive(Clone, Copy)]
struct Pt { pub u: f64, v: f64 }
fn mirror_all(a: Pt) -> Vec<Pt> { vec![Pt { u: a.v, v: a.u }] }""",
    "places.rs": """struct Pt(f64, f64);
fn mirror_all(a: Pt) -> Vec<Pt> { vec![Pt(a.1, a.0)] }""",
    "alias.go": """package main
type (
	Vector struct{ X, Y float64 }
	Pt = Vector
)
func mirrorAll(A Pt) []Pt { return []Pt{{A.Y, A.X}} }""",
    "typedef.cpp": """#define x first
#define y second
typedef std::pair<double, double> Pt;
int link[26], write = 1; // names of unistd.h, which it does not include
std::vector<Pt> mirror_all(Pt A) { return {{A.y, A.x}}; }""",
    "tag.c": """struct point { double x, y; };
typedef struct point Pt;
int link[26];
static int read(void) { return getchar(); }
int mirror_all(Pt A, Pt out[2]) { out[0] = (Pt){A.y, A.x}; return 1 + 0 * link[3]; }
int main(void) { return read(); }""",
    "methods.java": """import java.util.*;
class Pt {
    final double x, y;
    Pt(double x, double y) { this.x = x; this.y = y; }
    static List<Pt> mirrorAll(Map<Pt, Pt> all, Pt more) { return List.of(); }
    List<Pt> mirrorAll() { return List.of(new Pt(y, x)); }
}
class Solution { static List<Pt> mirrorAll(Pt A) { return A.mirrorAll(); } }""",
}


@pytest.mark.parametrize("name", daily(OWN, ["grouped.go", "fields.rs", "tag.c", "methods.java"]))
def test_types_and_names_of_its_own_are_taken(name):
    assert answers(name, OWN[name], PLACED, [((1.5, 2.0),)]) == [[[2, 1.5]]]


def test_a_type_of_its_own_that_does_not_fit_is_told():
    source = "package main\ntype Pt [2]float64\nfunc mirrorAll(A Pt) []Pt { return nil }"
    with box_of("a.go", source, signature=PLACED) as box:
        message = box.inspect().fault.message
    assert message.endswith("func mirrorAll(A Pt) []Pt, with type Pt struct{ X, Y float64 }")


def test_what_is_no_text_is_told():
    need("rust")
    with AnyBoxes(Boxes(None), REAL)(b"fn mirror_all(x: f64) -> f64 { x } // \xe9", "a.rs") as box:
        assert box.inspect().fault.message == "stream did not contain valid UTF-8"
    with AnyBoxes(Boxes(None), REAL)("def mirror_all(x):".encode("utf-16"), "a.pypy") as box:
        assert box.inspect().fault.message == "it is UTF-16: save it as UTF-8"


def test_what_is_blanked_at_the_head_of_a_file_keeps_its_lines():
    source = "#![allow(\n    unused)]\nfn mirror_all(x: f64) -> f64 { y }"
    with box_of("a.rs", source, signature=REAL) as box:
        assert box.inspect().fault[1:3] == (3, 32)
