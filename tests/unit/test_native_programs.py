"""Programs in other languages: compiled, kept, run; how each way to end is told."""

from __future__ import annotations

import pytest
from native import LIMITS, box_of, fault_of, ran

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


@pytest.mark.parametrize("name", ADDING)
def test_a_program_is_compiled_and_run(name):
    done = ran(name, ADDING[name], b"19 23\n")
    assert (done.stop, done.stdout, done.detail) == (Stop.ANSWERED, b"42\n", "")
    assert done.usage.memory_bytes > 1 << 20


def test_a_java_program_starts_in_the_class_with_the_main():
    main = "public static void main(String[] words) { System.out.print(7); }"
    source = f"package a.b;\nclass Pt {{ double x, y; }}\nclass Other {{ {main} }}"
    assert ran("x.java", source).stdout == b"7"


@pytest.mark.parametrize("level", ["full", "strong", "limits"])
@pytest.mark.parametrize("name", ["a.cpp", "a.go"])
def test_it_runs_at_each_level(name, level, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    try:
        with box_of(name, ADDING[name], level=level) as box:
            done = box.run_program(b"1 2\n", LIMITS)
            assert (done.stdout, box.isolation) == (b"3\n", level)
    except JudgeError as fault:
        if "cannot be had" not in str(fault):
            raise
        pytest.skip(str(fault))


@pytest.mark.parametrize(
    ("name", "source", "line", "column", "words"),
    [
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
            5,
            13,
            "no match for ‘operator<’",
        ),
    ],
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


ENDS = [
    ("a.c", "int main(void) { return 7; }", Stop.EXITED, "exit status 7"),
    ("a.c", "int main(void) { *(volatile int *)0 = 1; }", Stop.EXITED, "killed by SIGSEGV"),
    ("a.c", "int main(void) { for (;;); }", Stop.CPU, "CPU time"),
    ("a.c", '#include <stdio.h>\nint main(void) { for (;;) puts("x"); }', Stop.OUTPUT, "wrote more than"),
    (
        "a.cpp",
        (
            "#include <string>\n#include <vector>\n"
            "int main() { std::vector<std::string> v; for (;;) v.emplace_back(1 << 20, 'x'); }"
        ),
        Stop.MEMORY,
        "256 MB",
    ),
    (
        "a.cpp",
        '#include <stdexcept>\nint main() { throw std::runtime_error("lost"); }',
        Stop.EXITED,
        "lost",
    ),
    ("a.go", "package main\nfunc main() { var a []int; _ = a[3] }", Stop.EXITED, "index out of range"),
    (
        "a.go",
        (
            "package main\nvar k [][]byte\nfunc main() { for { b := make([]byte, 1<<20)\n"
            "for i := range b { b[i] = 1 }\nk = append(k, b) } }"
        ),
        Stop.MEMORY,
        "256 MB",
    ),
    (
        "a.go",
        'package main\nimport "fmt"\nfunc main() { for i := 0; i < 3000000; i++ { fmt.Println("xxxxxx") } }',
        Stop.OUTPUT,
        "wrote more than",
    ),
    (
        "A.java",
        "class A { public static void main(String[] w) { int[] a = {}; a[0]++; } }",
        Stop.EXITED,
        "ArrayIndex",
    ),
    (
        "A.java",
        (
            "import java.util.*; class A { public static void main(String[] w) {"
            " var k = new ArrayList<byte[]>(); for (;;) k.add(new byte[1 << 20]); } }"
        ),
        Stop.MEMORY,
        "256 MB",
    ),
    ("a.js", "null.x", Stop.EXITED, "TypeError"),
    ("a.js", "const k = []; for (;;) k.push(Buffer.alloc(1 << 20, 1));", Stop.MEMORY, "JavaScript's own"),
    (
        "a.rs",
        'fn main() { let v: Vec<i32> = vec![]; println!("{}", v[2]); }',
        Stop.EXITED,
        "index out of bounds",
    ),
]


@pytest.mark.parametrize(
    ("name", "source", "stop", "words"), ENDS, ids=[f"{row[0]}-{row[2].value}" for row in ENDS]
)
def test_each_end_is_told(name, source, stop, words):
    done = ran(name, source, limits=LIMITS._replace(cpu_seconds=1.0))
    assert (done.stop, words in done.detail) == (stop, True), (done.stop, done.detail, done.stderr)


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


@pytest.mark.parametrize("level", ["full", "strong"])
@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("a.c", "#include <assert.h>\nint main(int n, char **w) { assert(n == 2); }"),
        ("a.go", 'package main\nfunc main() { panic("lost") }'),
        ("a.rs", 'fn main() { panic!("lost") }'),
        ("A.java", 'class A { public static void main(String[] w) { throw new RuntimeException("lost"); } }'),
    ],
)
def test_a_program_knows_no_path_of_this_machine(name, source, level, monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    done = ran(name, source, level=level)
    assert done.stop is Stop.EXITED
    assert b"solution" in done.stderr or b"A.java" in done.stderr
    assert b"judge-" not in done.stderr
    assert b"/source" not in done.stderr
