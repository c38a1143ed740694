"""Languages beside Python: their descriptions, and what this machine has of them."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

from judge import languages as face
from judge.errors import JudgeError
from judge.languages import find, model


@pytest.fixture(autouse=True)
def fresh(monkeypatch, tmp_path):
    """Descriptions and tools are looked for anew, and nothing is kept elsewhere."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    model.languages.cache_clear()
    model.near_languages.cache_clear()
    find.toolchain.cache_clear()
    yield
    model.languages.cache_clear()
    model.near_languages.cache_clear()
    find.toolchain.cache_clear()


def script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


@pytest.mark.parametrize(
    ("name", "language"),
    [
        ("a.cpp", "cpp"),
        ("dir/a.b.cc", "cpp"),
        ("a.c", "c"),
        ("Main.java", "java"),
        ("a.go", "go"),
        ("a.rs", "rust"),
        ("a.mjs", "javascript"),
        ("a.pypy.py", "pypy"),
        ("a.py", None),
        ("a.b.py", None),
        ("a.h", None),
        ("0.5", None),
        ("segment", None),
    ],
)
def test_a_suffix_says_the_language(name, language):
    found = face.language_of(name)
    assert (found.id if found else None) == language
    assert face.is_program(name) == (language is not None or name.endswith(".py"))


def test_a_hidden_file_is_no_program_in_any_language():
    assert not face.is_program(".a.cpp")


def test_a_programs_name_ends_as_its_language_has_it():
    assert face.file_name("mine", model.language_called("go")) == "mine.go"


@pytest.mark.parametrize("word", ["C++", "cpp", "CPP", ".cc", "cc"])
def test_a_language_is_called_by_name_or_suffix(word):
    assert model.language_called(word).id == "cpp"


def test_no_language_is_called_so():
    assert model.language_called("cobol") is None


def test_names_are_spelt_as_each_language_has_it():
    spelt = {each.id: each.spelt("signed_area") for each in model.languages()}
    assert spelt["cpp"] == spelt["c"] == spelt["rust"] == "signed_area"
    assert spelt["java"] == spelt["go"] == spelt["javascript"] == "signedArea"


@pytest.mark.parametrize("language", model.languages(), ids=lambda each: each.id)
def test_each_description_is_whole(language):
    assert set(language.install) >= {"apt-get", "dnf", "brew"}
    assert re.compile(language.main)
    assert re.compile(language.head("f"))
    known = {"out", "scratch", "source", "sources", "folder", "box", "main", "class", "memory"}
    known |= {*language.tools, *language.homes, *language.folders, *language.probes, *language.prepared}
    runs = language.running
    words = [*language.version, *runs.command, *runs.reads, *runs.runs, *runs.environment.values()]
    compiles = language.compiling
    words += [word for step in compiles.steps for word in step]
    words += [*compiles.reads, *compiles.runs, *compiles.environment.values(), language.file]
    assert {name for word in words for name in re.findall(r"\{(\w+)\}", word)} <= known
    suffixes = [suffix for each in model.languages() for suffix in each.suffixes]
    assert len(suffixes) == len(set(suffixes))


@pytest.mark.parametrize(
    ("language", "source", "defines"),
    [
        ("c", "int two_points(double x, double y) {", True),
        ("c", "double *two_points(void)\n{", True),
        ("c", "int two_points(double x);", False),
        ("c", "int main(void) { return two_points(1); }", False),
        ("cpp", "std::vector<Pt> two_points(Pt a, Pt b)\n{", True),
        ("cpp", "auto x = two_points(a, b); if (x) {", False),
        ("cpp", "auto two_points(double x) noexcept(true) -> std::vector<Pt> {", True),
        ("cpp", "auto two_points(std::function<Pt(Pt (*)(int))> f) -> decltype(f(0)) {", True),
        ("cpp", "auto two_points = [&](Pt a) {", True),
        ("c", "int two_points(int (*f)(int), int n[(2)]) __attribute__((noinline)) {", True),
        ("go", "func twoPoints(a, b Pt) []Pt {", True),
        ("go", "twoPoints(a, b)", False),
        ("java", "static List<Pt> twoPoints(Pt a, Pt b) {", True),
        ("java", "static int[] twoPoints(Pt a) throws Exception {", True),
        ("rust", "fn two_points(a: Pt) -> Vec<Pt> {", True),
        ("javascript", "function twoPoints(a) {", True),
        ("javascript", "const twoPoints = (a) => a;", True),
    ],
)
def test_the_entry_is_known_where_it_is_defined(language, source, defines):
    described = model.language_called(language)
    assert bool(re.search(described.head("two_points"), source)) == defines


def test_a_broken_description_is_one_line(monkeypatch, tmp_path):
    folder = tmp_path / "own"
    folder.mkdir()
    (folder / "ada.toml").write_text('name = "Ada"\n')
    monkeypatch.setenv("JUDGE_LANGUAGES", str(folder))
    with pytest.raises(JudgeError, match=r"ada\.toml: it describes no language: .*suffixes"):
        model.languages()


@pytest.mark.parametrize(("key", "text"), [("drops", "'('"), ("swaps", "[['(', '']]")])
def test_a_pattern_that_is_none_is_one_line(monkeypatch, tmp_path, key, text):
    folder = tmp_path / "own"
    folder.mkdir()
    (folder / "tiny.toml").write_text(f"{key} = {text}\n" + (model._HERE / "c.toml").read_text())
    monkeypatch.setenv("JUDGE_LANGUAGES", str(folder))
    with pytest.raises(JudgeError, match=rf"tiny\.toml: it describes no language: {key} is no pattern"):
        model.languages()


def test_a_folder_without_descriptions_is_told(monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path / "nothing"))
    with pytest.raises(JudgeError, match=r"correct \$JUDGE_LANGUAGES"):
        model.languages()


def test_a_folder_of_ones_own_adds_a_language(monkeypatch, tmp_path):
    folder = tmp_path / "own"
    folder.mkdir()
    text = (
        (model._HERE / "c.toml").read_text().replace('name = "C"', 'name = "Tiny"').replace('".c"', '".tiny"')
    )
    (folder / "tiny.toml").write_text(text)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(folder))
    assert face.language_of("a.tiny").name == "Tiny"
    assert face.language_of("a.c").name == "C"


@pytest.mark.parametrize(
    ("manager", "command"), [("apt-get", "apt-get install golang-go"), ("brew", "brew install go")]
)
def test_a_missing_tool_is_told_with_the_command_that_installs_it(monkeypatch, tmp_path, manager, command):
    script(tmp_path / manager, "")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(JudgeError) as told:
        find.toolchain(model.language_called("go"))
    assert str(told.value) == f"Go needs go, which is not installed; {command}"


def test_without_a_package_manager_the_tools_are_named(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find.remedy(model.language_called("rust")) == "install rustc and cc"


def test_tools_are_asked_once_and_again_when_they_change(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    asked = tmp_path / "asked"
    tool = (
        f'echo "$@" >> {asked}; case "$2" in GO*) echo {tmp_path};; *) echo "packagefile fmt={asked}";; esac'
    )
    script(tmp_path / "go", tool)
    go = model.language_called("go")
    first = find.toolchain(go)
    assert first.values["goroot"] == str(tmp_path)
    assert dict(first.files) == {"importcfg": f"packagefile fmt={asked}\n".encode()}
    times = len(asked.read_text().splitlines())
    find.toolchain.cache_clear()
    assert find.toolchain(go) == first
    assert len(asked.read_text().splitlines()) == times
    script(tmp_path / "go", f"{tool}\n# another version")
    find.toolchain.cache_clear()
    assert find.toolchain(go).key != first.key
    assert len(asked.read_text().splitlines()) > times


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
    assert find.found(go).missing.endswith("go env GOROOT fails: no default is set")


def test_python_alone_reads_no_description():
    code = (
        "import sys\nfrom judge.languages import is_program, language_of\n"
        "assert is_program('a.py') and not is_program('segment') and not language_of('0.5')\n"
        "print([name for name in sys.modules if name.startswith('judge.languages.') or name == 'tomllib'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout == "[]\n"
