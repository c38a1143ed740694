"""Languages beside the judge's own: one's own folders, packages that bring some, drivers with faults."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest
from native import ran

from judge import languages as face
from judge.errors import JudgeError
from judge.languages import draft, model
from judge.languages.shapes import Unsupported
from judge.languages.signature import Signature
from judge.sandbox.probe import missing
from judge.values.atoms.int import IntType

C = (model._HERE / "c.toml").read_text(encoding="utf-8")
SIGNATURE = Signature("middle", (), IntType())
DRIVER = """\
def declared(draft):
    return f"fun {draft.entry}"
def frame(draft, words):
    return "", words
def driver(draft):
    raise ValueError("too tiny")
"""


@pytest.fixture(autouse=True)
def fresh(monkeypatch):
    """Descriptions and drivers are read anew."""
    caches = (model.near_languages, model.languages, draft.driver_of)
    monkeypatch.delenv("JUDGE_LANGUAGES", raising=False)
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


def described(folder, driver=None, name="tiny", suffix=".tiny"):
    """A folder with a language that is C in all but its name."""
    folder.mkdir(parents=True)
    text = C.replace('name = "C"', f'name = "{name.capitalize()}"').replace('".c"', f'"{suffix}"')
    (folder / f"{name}.toml").write_text(text)
    if driver is not None:
        (folder / f"{name}.py").write_text(driver)
    return folder


def installed(tmp_path, monkeypatch, value="tiny_pack", **more):
    """A distribution that is installed and brings a language."""
    described(tmp_path / "tiny_pack", **more)
    (tmp_path / "tiny_pack" / "__init__.py").write_text("")
    record = tmp_path / "tiny_pack-1.dist-info"
    record.mkdir()
    (record / "METADATA").write_text("Metadata-Version: 2.1\nName: tiny-pack\nVersion: 1\n")
    (record / "entry_points.txt").write_text(f"[judge.languages]\ntiny = {value}\n")
    monkeypatch.syspath_prepend(tmp_path)


def test_a_package_brings_a_language(tmp_path, monkeypatch):
    installed(tmp_path, monkeypatch)
    assert face.language_of("a.tiny").name == "Tiny"
    assert model.language_called("tiny") is face.language_of("b.tiny")
    assert "tiny" in [each.id for each in model.languages()]


def test_what_is_near_goes_before_what_is_installed(tmp_path, monkeypatch):
    installed(tmp_path, monkeypatch, name="other", suffix=".c")
    assert face.language_of("a.c").name == "C"
    monkeypatch.setenv("JUDGE_LANGUAGES", str(described(tmp_path / "own", name="other", suffix=".own")))
    model.near_languages.cache_clear()
    model.languages.cache_clear()
    assert face.language_of("a.own").folder == str(tmp_path / "own")
    assert [each.suffixes for each in model.languages() if each.id == "other"] == [(".own",)]


@pytest.mark.parametrize("value", ["nowhere_at_all", "tiny_pack:missing"])
def test_a_package_that_cannot_be_loaded_is_one_line(tmp_path, monkeypatch, value):
    installed(tmp_path, monkeypatch, value)
    with pytest.raises(JudgeError, match=r"the languages 'tiny' cannot be loaded: .*repair or uninstall it"):
        face.language_of("a.tiny")


def test_an_own_suffix_asks_for_nothing_that_is_installed():
    code = (
        "import sys\nfrom judge.languages import language_of\n"
        "assert language_of('a.cpp').id == 'cpp'\nprint('importlib.metadata' in sys.modules)\n"
        "assert language_of('a.txt') is None\nprint('importlib.metadata' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout == "False\nTrue\n"


def test_a_relative_folder_stays_the_same_when_the_judge_goes_elsewhere(tmp_path, monkeypatch):
    described(tmp_path / "own", DRIVER)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JUDGE_LANGUAGES", "own")
    tiny = model.language_called("tiny")
    monkeypatch.chdir("/")
    assert draft.driver_of(tiny).declared(draft.draft_of(tiny, SIGNATURE)) == "fun middle"


def tiny(tmp_path, monkeypatch, driver):
    monkeypatch.setenv("JUDGE_LANGUAGES", str(described(tmp_path / "own", driver)))
    return model.language_called("tiny")


def test_without_a_driver_there_are_programs_only(tmp_path, monkeypatch):
    with pytest.raises(Unsupported):
        draft.driver_of(tiny(tmp_path, monkeypatch, None))


@pytest.mark.parametrize(
    ("driver", "told"),
    [
        ("def declared(:\n", r"tiny\.py: the driver of Tiny cannot be loaded: SyntaxError"),
        ("import nothing_of_that_name\n", r"tiny\.py: .*ModuleNotFoundError"),
        (DRIVER.replace("frame", "body"), r"the driver of Tiny has no frame"),
    ],
)
def test_a_broken_driver_is_one_line(tmp_path, monkeypatch, driver, told):
    language = tiny(tmp_path, monkeypatch, driver)
    with pytest.raises(JudgeError, match=told):
        draft.driver_of(language)


def test_a_driver_that_fails_is_one_line(tmp_path, monkeypatch):
    language = tiny(tmp_path, monkeypatch, DRIVER)
    with pytest.raises(JudgeError, match=r"Tiny's driver fails: ValueError: too tiny; correct it"):
        draft.driver_of(language).driver(draft.draft_of(language, SIGNATURE))


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
        (with_line("drops = '('"), "drops is no pattern"),
        (with_line("swaps = [['(', '']]"), "swaps is no pattern"),
        (with_line("defines = '('"), "defines is no pattern"),
        (
            with_line("complaint = 'line (?P<line>[0-9]+)'"),
            "complaint needs the groups message, file and line",
        ),
    ],
)
def test_a_broken_description_is_one_line(tmp_path, monkeypatch, text, told):
    (tmp_path / "ada.toml").write_text(text)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path))
    with pytest.raises(JudgeError, match=rf"ada\.toml: it describes no language: {told}"):
        model.languages()


def test_a_folder_without_descriptions_is_told(monkeypatch, tmp_path):
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path / "nothing"))
    with pytest.raises(JudgeError, match=r"correct \$JUDGE_LANGUAGES"):
        model.languages()


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
itself = "{sh}/is/me"
[run]
command = ["/usr/bin/cat", "{box}/main"]
runs = ["/usr/bin", "/usr/lib"]
"""


def test_a_compiler_may_look_for_its_own_file_where_there_is_no_proc(tmp_path, monkeypatch):
    if missing("full"):
        pytest.skip(missing("full"))
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "who.toml").write_text(ITSELF)
    monkeypatch.setenv("JUDGE_LANGUAGES", str(tmp_path / "own"))
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    shell = os.path.realpath(shutil.which("sh"))
    assert ran("a.who", "", level="full").stdout.decode() == f"{shell}/is/me\n"
