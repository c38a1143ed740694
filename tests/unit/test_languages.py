"""Languages beside Python: their descriptions, what this machine has of them, and those that others bring."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from native import ran, signature
from sandboxed import require

from judge import languages as face
from judge.errors import JudgeError
from judge.languages import find, model, spell
from judge.languages.sources import sources_of

FOLDER = Path(face.__file__).parent
C = (FOLDER / "c" / "language.toml").read_text(encoding="utf-8")


@pytest.fixture(autouse=True)
def fresh(monkeypatch, tmp_path):
    """Descriptions and tools are looked for anew, and nothing is kept elsewhere."""
    caches = (model.languages, find.toolchain)
    monkeypatch.delenv("JUDGE_LANGUAGES", raising=False)
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


def script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


@pytest.mark.parametrize(
    ("language", "names"),
    [
        ("cpp", ["a.cpp", "dir/a.b.cc"]),
        ("javascript", ["a.mjs"]),
        ("pypy", ["a.pypy.py"]),
        ("python", ["a.py", "../a.b.py"]),
        (None, ["a.h", "0.5", "segment", "a.pyc", "a.PY", ".py", ".#a.py", "py"]),
    ],
)
def test_a_suffix_says_the_language(language, names):
    for name in names:
        found = face.language_of(name)
        assert (found.id if found else None) == (None if language == "python" else language), name
        assert face.is_program(name) == (language is not None), name
        assert face.spelt("signed_area", name) == (
            "signedArea" if language == "javascript" else "signed_area"
        )
    assert not face.is_program(".a.cpp"), "it is hidden"


def test_a_missing_tool_is_told_with_the_command_that_installs_it(monkeypatch, tmp_path):
    script(tmp_path / "apt-get", "")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(JudgeError) as told:
        find.toolchain(model.language_called("go"))
    assert str(told.value) == "Go needs go, which is not installed; apt-get install golang-go"


def test_what_is_kept_of_tools_goes_with_what_it_names(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    packages = tmp_path / "packages"
    packages.mkdir()
    script(
        tmp_path / "go",
        f'mkdir -p {packages}; echo "$2" | grep -q ^GO && echo {packages} || echo "a={packages}"',
    )
    go = model.language_called("go")
    find.toolchain(go)
    packages.rmdir()
    find.toolchain.cache_clear()
    find.toolchain(go)
    assert packages.exists()


def test_a_tool_chain_that_does_not_answer_is_none(monkeypatch, tmp_path):
    """Such as rustup's `rustc` under a home that has no default."""
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    script(tmp_path / "go", "echo no default is set >&2; echo ' 13: <unknown>' >&2; exit 3")
    go = model.language_called("go")
    with pytest.raises(JudgeError, match=r"go env GOROOT fails: no default is set; repair it, or "):
        find.toolchain(go)
    assert not find.missing(go)
    assert "go env GOROOT fails: no default is set (repair it" in find.why_not(go)
    broken = find.found(go)
    assert (broken.works, broken.missing) == (False, "")
    assert broken.why_not.endswith("go env GOROOT fails: no default is set")

    monkeypatch.setattr(find, "_PATIENCE", 0.5)
    script(tmp_path / "go", "exec sleep 60")
    with pytest.raises(JudgeError, match=r"go env GOROOT does not answer within 0.5 s; repair it, or "):
        find.toolchain(go)


# -- languages that others describe -------------------------------------------------------------------------


def with_line(line):
    """C's description with another line for one of its keys, or with one more of [compile]."""
    key = line.partition(" ")[0]
    kept = [each for each in C.splitlines() if not each.startswith(key)]
    place = next(i for i, each in enumerate(kept) if each.startswith("steps")) if key == "complaint" else 1
    return "\n".join([*kept[:place], line, *kept[place:]])


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('name = "Ada"\n', ".*suffixes"),
        (with_line("defines = '('"), "defines is not a pattern"),
        (
            with_line("complaint = 'line (?P<line>[0-9]+)'"),
            "complaint needs the groups message, file and line",
        ),
    ],
)
def test_a_broken_description_is_one_line(tmp_path, monkeypatch, text, told):
    (tmp_path / "ada").mkdir()
    (tmp_path / "ada" / "language.toml").write_text(text)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path))
    with pytest.raises(JudgeError, match=rf"ada/language\.toml: it describes no language: {told}"):
        model.languages()


def test_a_folder_without_any_is_told(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path))
    with pytest.raises(JudgeError, match=r"no language is described here; correct \$JUDGE_LANGUAGES"):
        model.languages()


SOURCE = b"double mirror_all(double x) { return x; } int main(void) { return 0; }"
HOOKS = {
    "def": r"ada/hook\.py: the hook of C cannot be loaded: SyntaxError: .*; correct it",
    "def reads(writer, shape): return writer.none": "ada: C's driver cannot be written: AttributeError: .*",
    "def head(writer, shape): return writer.write('head', shape)": "ada: C's head cannot be .*RecursionError",
    "def adapted(source): return source.none": "ada: C's file cannot be written: AttributeError: .*",
}


@pytest.fixture
def ada(tmp_path, monkeypatch):
    """A language of one's own, which is C."""
    folder = tmp_path / "ada"
    shutil.copytree(FOLDER / "c", folder)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path))
    return folder


def called(source=SOURCE):
    return sources_of(model.language_called("ada"), source, signature("real", x="real"))


@pytest.mark.parametrize("hook", HOOKS)
def test_a_fault_of_a_hook_is_one_line(ada, hook):
    (ada / "hook.py").write_text(hook)
    with pytest.raises(JudgeError, match=HOOKS[hook]):
        called()


def test_what_a_description_lacks_is_told(ada):
    text = C.replace("[spell.head]", "[spell.headless]")
    (ada / "language.toml").write_text(text)
    with pytest.raises(JudgeError, match=r"ada: spell has no head; define what 'judge help programs' says"):
        called()


def test_without_a_driver_each_file_is_a_program(ada):
    assert called().entry == "mirror_all"
    (ada / "driver.c").unlink()
    spell._driver.cache_clear()
    assert (called().entry, called().fault) == ("", None)
    assert "give it a main" in called(SOURCE.partition(b"int")[0]).fault.message


ITSELF = """\
name = "Who"
suffixes = [".who"]
order = 9
spelling = "snake"
file = "solution.who"
main = ''
empty = "nothing"
version = ["{sh}", "-c", "echo 1"]
[tools]
sh = ["sh"]
[install]
[compile]
steps = [["{sh}", "-c", "/usr/bin/readlink /proc/self/exe > {out}/main"]]
runs = ["/usr/bin", "/usr/lib"]
[run]
command = ["/usr/bin/cat", "{box}/main"]
runs = ["/usr/bin", "/usr/lib"]
"""


def test_a_compiler_may_look_for_its_own_file(tmp_path, monkeypatch):
    require("full")
    (tmp_path / "own" / "who").mkdir(parents=True)
    (tmp_path / "own" / "who" / "language.toml").write_text(ITSELF)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path / "own"))
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    readlink = os.path.realpath("/usr/bin/readlink")
    assert ran("a.who", "", level="full").stdout.decode() == f"{readlink}\n"
