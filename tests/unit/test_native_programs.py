"""Programs in other languages: compiled, kept, run; how each way to end is told."""

from __future__ import annotations

import pytest
from native import LIMITS, box_of, fault_of, ran, sources
from sampling import daily
from sandboxed import require

from judge.languages.store import CacheStore
from judge.sandbox import Stop, Usage

pytestmark = pytest.mark.slow

ADDING = sources("adding")  # the sum of two numbers on a line


@pytest.mark.parametrize("name", daily(ADDING, ["a.c", "a.go", "Any.java", "a.cjs"]))
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


ENDS = {
    "status.c": ("exited", "exit status 7"),
    "signal.c": ("exited", "killed by SIGSEGV"),
    "time.c": ("cpu", "CPU time"),
    "output.c": ("output", "wrote more than"),
    "memory.java": ("memory", "256 MB"),
    "memory.js": ("memory", "JavaScript's own"),
    "fault.cpp": ("exited", "lost"),
    "fault.go": ("exited", "index out of range"),
    "fault.java": ("exited", "ArrayIndex"),
    "fault.rs": ("exited", "index out of bounds"),
}


@pytest.mark.parametrize("name", daily(ENDS, [each for each in ENDS if "memory" not in each]))
def test_each_end_is_told(name):
    done = ran(name, sources("ends")[name], limits=LIMITS._replace(cpu_seconds=1.0))
    stop, words = ENDS[name]
    assert (done.stop.value, words in done.detail) == (stop, True), (done.stop, done.detail, done.stderr)


def test_shared_memory_that_no_limit_counts_is_refused():
    source = (
        "#include <stdio.h>\n#include <string.h>\n#include <sys/mman.h>\n"
        "int main(void) { size_t n = 900u << 20;"
        " void *p = mmap(0, n, 3, MAP_SHARED | MAP_ANONYMOUS, -1, 0);"
        ' if (p == MAP_FAILED) { puts("no"); return 0; } memset(p, 1, n); puts("yes"); }'
    )
    assert ran("a.c", source).stdout == b"no\n"


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
