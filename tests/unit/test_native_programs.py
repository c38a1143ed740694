"""Programs in other languages: compiled, kept, run; how each way to end is told."""

from __future__ import annotations

import pytest
from native import LIMITS, box_of, fault_of, ran
from sampling import daily, nightly

from judge.errors import JudgeError
from judge.languages import find
from judge.languages.boxes import AnyBoxes
from judge.languages.store import CacheStore
from judge.sandbox import Boxes, Stop, Usage

pytestmark = pytest.mark.slow

ADDING = {  # the sum of two numbers on a line
    "a.c": '#include <stdio.h>\nint main(void) { int a, b; scanf("%d%d", &a, &b); printf("%d\\n", a + b); }',
    "a.cpp": "#include <iostream>\nint main() { int a, b; std::cin >> a >> b; std::cout << a + b << '\\n'; }",
    "a.go": 'package main\nimport "fmt"\nfunc main() { var a, b int; fmt.Scan(&a, &b); fmt.Println(a + b) }',
    "Any.java": (
        "import java.util.*;\npublic class Sum { public static void main(String[] w) {"
        " var in = new Scanner(System.in); System.out.println(in.nextInt() + in.nextInt()); } }"
    ),
    "a.rs": (
        "use std::io::*;\nfn main() { let mut t = String::new(); stdin().read_to_string(&mut t).unwrap();"
        ' println!("{}", t.split_whitespace().map(|w| w.parse::<i32>().unwrap()).sum::<i32>()); }'
    ),
    "a.js": (
        "const w = require('fs').readFileSync(0, 'utf8').trim().split(/\\s+/).map(Number);"
        " console.log(w[0] + w[1]);"
    ),
    "a.cjs": (
        "const w = require('fs').readFileSync('/dev/stdin', 'utf8').split(' ').map(Number); // it has '/*'\n"
        " console.log(w[0] + w[1]);"
    ),
    "a.pypy": "print(sum(map(int, input().split())))",
}


@pytest.mark.parametrize("name", daily(ADDING, ["a.c", "a.go", "Any.java", "a.cjs"]))
def test_a_program_is_compiled_and_run(name):
    done = ran(name, ADDING[name], b"19 23\n")
    assert (done.stop, done.stdout, done.detail) == (Stop.ANSWERED, b"42\n", "")
    assert done.usage.memory_bytes > 1 << 20


@pytest.mark.nightly
def test_a_java_program_starts_in_the_class_with_the_main():
    main = "public static void main(String[] words) { System.out.print(7); }"
    source = f"package a.b;\nclass Pt {{ double x, y; }}\nclass Other {{ {main} }}"
    assert ran("x.java", source).stdout == b"7"


BROKEN = [
    ("a.c", "int main(void)\n{ return 0 }", 2, 11, "expected"),
    ("a.cpp", "int main() {\n  return none;\n}", 2, 10, "none"),
    ("a.go", "package main\nfunc main() {\n\tx := 1\n}", 3, 2, "declared"),
    ("A.java", "class A {\n int x = ;\n void main() {} }", 2, 10, "illegal start"),
    ("A.java", "class A {\n\tint x = 1 + y;\n void main() {} }", 2, 14, "cannot find symbol: variable y"),
    ("a.rs", "fn main() {\n let x: i32 = 1.5;\n}", 2, 15, "mismatched"),
    ("a.js", "let a = 1;\nlet a = 2;\n", 2, 5, "SyntaxError"),
    ("a.pypy", "a = 1\nb = (\n", 2, 0, "SyntaxError"),
    (
        "a.cpp",
        "#include <set>\nstruct Pt {};\nint main() {\n  std::set<Pt> all;\n  all.insert(Pt());\n}",
        *(5, 13, "no match for ‘operator<’"),
    ),
]


@pytest.mark.parametrize(
    ("name", "source", "line", "column", "words"),
    [each if each[0] in ("a.c", "a.go", "a.js") else nightly(*each) for each in BROKEN],
)
def test_what_does_not_compile_is_told_with_its_place(name, source, line, column, words):
    fault = fault_of(name, source)
    assert (fault.line, fault.column) == (line, column), fault
    assert words in fault.message
    assert "/" not in fault.message.replace("//", "")


def test_an_undefined_function_is_found_by_the_linker_and_told():
    fault = fault_of("a.c", "int other(void);\nint main(void) { return other(); }")
    assert "undefined reference" in fault.message
    assert "/tmp" not in fault.message


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


def test_the_store_keeps_the_newest_and_takes_no_damage(tmp_path, monkeypatch):
    monkeypatch.setattr("judge.languages.store.MOST_KEPT", 2)
    store = CacheStore(lambda: tmp_path)
    for name in "abc":
        store.keep_artifact(name, [("x/main", name.encode())])
    assert store.artifact("a") is None
    assert store.artifact("c") == [("x/main", b"c")]
    store.keep_idle("k", Usage(0.1, 0.2, 3))
    assert store.idle("k") == Usage(0.1, 0.2, 3)
    assert store.idle("other") is None


def test_a_cache_that_cannot_be_written_costs_only_time(tmp_path):
    (tmp_path / "file").write_text("")
    store = CacheStore(lambda: tmp_path / "file")
    store.keep_artifact("a", [("main", b"")])
    assert store.artifact("a") is None


FILL = "import java.util.*; class A { public static void main(String[] w) {"
FILL += " var k = new ArrayList<byte[]>(); for (;;) k.add(new byte[1 << 20]); } }"
GROW = "package main\nvar k [][]byte\nfunc main() { for { b := make([]byte, 1<<20)\n"
GROW += "for i := range b { b[i] = 1 }\nk = append(k, b) } }"
ENDS = {
    "a status of a.c": ("int main(void) { return 7; }", "exited", "exit status 7"),
    "a signal of a.c": ("int main(void) { *(volatile int *)0 = 1; }", "exited", "killed by SIGSEGV"),
    "time of a.c": ("int main(void) { for (;;); }", "cpu", "CPU time"),
    "output of a.c": (
        '#include <stdio.h>\nint main(void) { for (;;) puts("x"); }',
        "output",
        "wrote more than",
    ),
    "memory of a.cpp": (
        "#include <cstdlib>\n#include <cstring>\nint main() { for (;;) memset(malloc(1<<20), 1, 1<<20); }",
        *("memory", "256 MB"),
    ),
    "a fault of a.cpp": (
        '#include <stdexcept>\nint main() { throw std::runtime_error("lost"); }',
        *("exited", "lost"),
    ),
    "a fault of a.go": (
        "package main\nfunc main() { var a []int; _ = a[3] }",
        "exited",
        "index out of range",
    ),
    "memory of a.go": (GROW, "memory", "256 MB"),
    "output of a.go": (
        'package main\nimport "fmt"\nfunc main() { for i := 0; i < 3000000; i++ { fmt.Println("xxxxxx") } }',
        *("output", "wrote more than"),
    ),
    "a fault of A.java": (
        "class A { public static void main(String[] w) { int[] a = {}; a[0]++; } }",
        *("exited", "ArrayIndex"),
    ),
    "memory of A.java": (FILL, "memory", "256 MB"),
    "a fault of a.js": ("null.x", "exited", "TypeError"),
    "memory of a.js": (
        "const k = []; for (;;) k.push(Buffer.alloc(1 << 20, 1));",
        *("memory", "JavaScript's own"),
    ),
    "a fault of a.rs": (
        'fn main() { let v: Vec<i32> = vec![]; println!("{}", v[2]); }',
        *("exited", "index out of bounds"),
    ),
}


@pytest.mark.parametrize(
    "end", daily(ENDS, [each for each in ENDS if "a.c" in each.split() or "fault" in each])
)
def test_each_end_is_told(end):
    source, stop, words = ENDS[end]
    done = ran(end.split()[-1], source, limits=LIMITS._replace(cpu_seconds=1.0))
    assert (done.stop.value, words in done.detail) == (stop, True), (done.stop, done.detail, done.stderr)


def test_shared_memory_that_no_limit_counts_is_refused():
    source = (
        "#include <stdio.h>\n#include <string.h>\n#include <sys/mman.h>\n"
        "int main(void) { size_t n = 900u << 20;"
        " void *p = mmap(0, n, 3, MAP_SHARED | MAP_ANONYMOUS, -1, 0);"
        ' if (p == MAP_FAILED) { puts("no"); return 0; } memset(p, 1, n); puts("yes"); }'
    )
    assert ran("a.c", source).stdout == b"no\n"


def test_a_missing_toolchain_costs_one_submission_and_names_the_command(monkeypatch, tmp_path):
    (tmp_path / "apt-get").write_text("#!/bin/sh\n")
    (tmp_path / "apt-get").chmod(0o755)
    find.toolchain.cache_clear()
    box = AnyBoxes(Boxes())(b"int main() {}", "a.cpp")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(JudgeError, match=r"C\+\+ needs g\+\+, which is not installed; apt-get install g\+\+"):
        box.__enter__()
    find.toolchain.cache_clear()


LOST = {
    "a.c": "#include <assert.h>\nint main(int n, char **w) { assert(n == 2); }",
    "a.go": 'package main\nfunc main() { panic("lost") }',
    "a.rs": 'fn main() { panic!("lost") }',
    "A.java": 'class A { public static void main(String[] w) { throw new RuntimeException("lost"); } }',
}


@pytest.mark.parametrize("level", ["full", "strong"])
@pytest.mark.parametrize("name", daily(LOST, ["a.c"]))
def test_a_program_knows_no_path_of_this_machine(name, level, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    done = ran(name, LOST[name], level=level)
    assert done.stop is Stop.EXITED
    assert b"solution" in done.stderr or b"A.java" in done.stderr
    assert b"judge-" not in done.stderr
    assert b"/source" not in done.stderr
