"""`judge site` without a browser: what it writes, and what the tab says of programs there."""

from __future__ import annotations

import json
import re
import shutil
import sys
import zipfile
from pathlib import Path
from urllib.error import URLError

import pytest
from jsonschema import Draft202012Validator
from mistaken import mistaken
from msgspec.structs import replace

from judge.cli.app import app
from judge.cli.commands import site
from judge.diagnose.trial import SearchBudget
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.problem.find import find_problem
from judge.sandbox.boundary import Limits, Stop
from judge.schema import schema_of
from judge.site import fetch
from judge.site.box import TabBox
from judge.site.build import PAGE, Site, _cards
from judge.site.tab import Tab
from judge.site.texts import kata_page, markdown

KATAS = Path(__file__).parent.parent / "fixtures" / "katas" / "problems"
LIMITS = Limits(0.2, 1.0, 256 << 20, 1 << 10)


class Quiet:
    """A page that hears nothing."""

    def alive(self): ...
    def memory(self):
        return 0

    def progress(self, done, cases): ...
    def told(self, text): ...


@pytest.fixture
def brought(tmp_path_factory, monkeypatch):
    """What others bring, without them."""
    folder = tmp_path_factory.mktemp("parts")
    (folder / "wheels").mkdir()
    (folder / "wheels" / "msgspec.whl").write_bytes(b"")
    monkeypatch.setattr(site, "parts", lambda *_: folder)
    return folder


def test_a_site_is_written_once_and_again_only_where_it_changed(judge, brought):
    first = json.loads(judge("site", "middle", "--out", "public", "--json").lines[0])
    assert (first["made"], first["kept"]) == (["middle"], [])
    Draft202012Validator(schema_of(app.get_command(None, "site"))).validate(first)
    assert {path.name for path in PAGE.iterdir()} <= {path.name for path in Path("public").iterdir()}
    assert "{{version}}" not in Path("public/sw.js").read_text()
    names = zipfile.ZipFile("public/judge.zip").namelist()
    assert "judge/site/tab.py" in names
    assert not [name for name in names if "attacks" in name or name.startswith("judge/cli")]
    before = Path("public/sw.js").read_bytes()
    Path("public/kata/gone.zip").write_bytes(b"of an earlier build")
    again = judge("site", "middle", "--out", "public")
    assert "1 as they were" in again.out
    assert Path("public/sw.js").read_bytes() == before
    assert [path.name for path in Path("public/kata").glob("*.zip")] == ["middle.zip"]


def test_a_kata_whose_cases_have_several_right_answers_is_shipped_from_the_cache_too(judge, brought):
    for out in ("cold", "warm"):
        said = judge("site", "by-size", "--problems", str(KATAS), "--out", out, "--json")
        assert json.loads(said.lines[0])["made"] == ["by-size"]
    cold, warm = (zipfile.ZipFile(f"{out}/kata/by-size.zip") for out in ("cold", "warm"))
    assert cold.namelist() == warm.namelist()
    assert cold.read("data.json") == warm.read("data.json")


@pytest.mark.slow
def test_a_build_that_was_stopped_goes_on(judge, brought, monkeypatch):
    def stop(label, done, _katas):
        if done:
            raise KeyboardInterrupt(label)

    problems = [find_problem(name, [KATAS]) for name in ("by-size", "rises")]
    with pytest.raises(KeyboardInterrupt):
        list(Site(Path("public"), problems, [KATAS], brought).build(stop))
    site.check_folder(Path("public"))
    again = Site(Path("public"), problems, [KATAS], brought)
    assert [*again.build()] == ["kata/rises.zip", "quiz.json"]
    built = again.built(opened=False)
    assert (built.made, built.kept) == (("rises",), ("by-size",))


@pytest.mark.slow
def test_a_change_of_a_mistake_alone_is_built_anew(tmp_path, brought):
    folder = tmp_path / "own"
    shutil.copytree(KATAS.parent, folder)
    (folder / "solutions/rises/wrong").mkdir(exist_ok=True)

    def missing():
        made = Site(Path("public"), [find_problem("rises", [folder / "problems"])], [], brought)
        found = [*made.missing]
        list(made.build())
        return found

    assert "kata/rises.zip" in missing()
    assert missing() == []
    (folder / "solutions/rises/wrong/never.py").write_text('"""never"""\n\n\ndef rises(*_):\n    return 0\n')
    assert "kata/rises.zip" in missing()


def test_nothing_of_others_is_written_over(judge, brought):
    Path("mine").mkdir()
    Path("mine/notes.txt").write_text("notes")
    refused = judge("site", "middle", "--out", "mine")
    assert (refused.status, refused.err.count("\n")) == (2, 1)
    assert [path.name for path in Path("mine").iterdir()] == ["notes.txt"]


def test_a_folder_that_cannot_be_made_is_told_in_one_line(judge, brought):
    Path("file").write_text("")
    refused = judge("site", "middle", "--out", "file/public")
    assert (refused.status, refused.err.count("\n")) == (2, 1)
    assert "file/public: cannot be written" in refused.err


def test_what_cannot_be_fetched_is_told_in_one_line(judge, monkeypatch, tmp_path):
    def refused(*_, **__):
        raise URLError(OSError(101, "Network is unreachable"))

    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "empty"))
    monkeypatch.setattr(fetch, "urlopen", refused)
    ended = judge("site", "middle", "--out", "public")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert "cannot be fetched: network is unreachable" in ended.err


@pytest.mark.parametrize("place", ["gone", "http://[", "http://127.0.0.1:1/\n", "http://127.0.0.1:1"])
def test_where_no_pyodide_is_the_place_is_named(place, judge):
    ended = judge("site", "middle", "--out", "public", "--pyodide", place)
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert "there is no pyodide.mjs: " in ended.err


@pytest.fixture(scope="module")
def tab(tmp_path_factory):
    """The katas of a site, opened in this interpreter."""
    out, katas = tmp_path_factory.mktemp("site"), tmp_path_factory.mktemp("katas")
    names = ("count", "which-side")
    list(Site(out, [find_problem(name) for name in names], [], tmp_path_factory.mktemp("parts")).build())
    made = Tab(Quiet(), str(katas))
    for name in names:
        zipfile.ZipFile(out / "kata" / f"{name}.zip").extractall(katas / name)
        made.open(name)
    return made


@pytest.mark.parametrize(
    ("kata", "mistake"),
    [
        ("count", "forgotten-centre"),
        ("count", "swapped-coordinates"),
        ("count", "absolute-epsilon"),
        ("which-side", "sides-exchanged"),
        ("which-side", "above-for-left"),
    ],
)
@pytest.mark.slow
def test_a_tab_says_what_a_session_says(tab, kata, mistake, monkeypatch):
    """Where calls are what ends a search: the guards of time count all that this process does."""
    for guard in ("cpu", "wall"):
        monkeypatch.setitem(SearchBudget.__init__.__kwdefaults__, guard, 1000.0)
    source = mistaken(kata, mistake)
    with Session(find_problem(kata), RunOptions(timed=False)) as session:
        other = session.judge(source, "yours.py")
    told = json.loads(tab.judge(kata, source.decode()))
    assert told["verdict"] == other.verdict.value == "WA"
    assert tab.result(kata, source).counterexample.replay == other.counterexample.replay
    assert tab.result(kata, source).pitfall == other.pitfall
    assert told["drawings"][0]["svg"].startswith("<svg")


BY_EQUALITY = b"""def line_count(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    if A == B:
        return None
    gap = abs((bx - ax) * (ay - cy) - (by - ay) * (ax - cx)) / ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5 - r
    return 1 if gap == 0 else 2 if gap < 0 else 0
"""


@pytest.mark.slow
def test_a_wrong_answer_says_what_its_case_turns_on(tab, judge, submit):
    told = json.loads(tab.judge("count", BY_EQUALITY.decode()))
    assert ["why", "the line touches the circle exactly"] in told["facts"]
    shown = judge("run", "count", submit(BY_EQUALITY.decode(), "count.py"))
    assert "    why       the line touches the circle exactly" in shown.lines


def test_a_program_on_standard_input_and_one_that_does_not_compile(tab):
    program = "for _ in range(int(input())):\n    input()\n    print(2)\n"
    before = sys.modules["__main__"], sys.argv, [*sys.path]
    assert json.loads(tab.judge("count", program))["how"] == "run as a program"
    assert (sys.modules["__main__"], sys.argv, sys.path) == before
    broken = json.loads(tab.judge("count", "def line_count(:\n"))
    assert (broken["verdict"], broken["source"][0]) == ("CE", "1 | def line_count(:")


LIAR = """class Liar(type):
    @property
    def __name__(cls): raise SystemExit(0)
class Mine(Exception, metaclass=Liar): pass
def f(x):
    raise Mine("x")
"""
CALLS = {
    "def f(x):\n    return 1 / x\n": (Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 2)"),
    "def f(x):\n    raise SystemExit(3)\n": (Stop.EXCEPTION, "SystemExit: 3 (line 2)"),
    "import nothing_of_that_name\ndef f(x): return x\n": (
        Stop.EXCEPTION,
        "ModuleNotFoundError: No module named 'nothing_of_that_name' (line 1), while the module was imported",
    ),
    LIAR: (Stop.EXCEPTION, "Mine: x (line 6)"),
    "def f(x):\n    print('a' * 2000)\n": (Stop.OUTPUT, "printed more than 0 MB"),
    "def f(x):\n    raise MemoryError\n": (Stop.MEMORY, "MemoryError (line 2)"),
}


@pytest.mark.parametrize("source", CALLS)
def test_how_a_call_ends(source):
    found = TabBox(source.encode(), "mine.py").call("f", [(0,)], LIMITS)
    assert (found.replies[0].stop, found.replies[0].detail) == CALLS[source]


PROGRAMS = {
    "print('\\ud800')": (Stop.EXCEPTION, b"", "UnicodeEncodeError"),
    "import sys; sys.stdout.buffer.write(b'x\\n'); sys.stdout.close()": (Stop.ANSWERED, b"x\n", ""),
    "exit('no answer')": (Stop.EXITED, b"", "exit status 1"),
    "raise KeyboardInterrupt": (Stop.EXCEPTION, b"", "KeyboardInterrupt (line 1)"),
}


@pytest.mark.parametrize("source", PROGRAMS)
def test_what_a_program_does_to_its_streams_is_its_own(source):
    stop, printed, detail = PROGRAMS[source]
    done = TabBox(source.encode(), "mine.py").run_program(b"", LIMITS)
    assert (done.stop, done.stdout) == (stop, printed)
    assert done.detail.startswith(detail)


@pytest.mark.skipif(sys.version_info < (3, 12), reason="before Python 3.12 jumps cannot be counted")
def test_a_loop_ends_with_its_line():
    box = TabBox(b"def f(x):\n    while True: pass\n", "mine.py")
    found = box.call("f", [(0,), (1,)], LIMITS)
    assert len(found.replies) == 1
    assert found.replies[0].stop is Stop.CPU
    assert re.fullmatch(r"used more than 0\.6 s of CPU time \(line \d\)", found.replies[0].detail)


def test_the_remark_of_an_example_may_stand_above_its_call():
    found = markdown("    >>> f(1)   # one\n    1\n    >>> f(2)\n    2\n")
    rows = '<span class="call"><span>&gt;&gt;&gt; f(1)   </span><span># one</span></span>1'
    assert rows in found
    assert found.count("call") == 1


def test_a_statement_without_a_figure_asks_for_none(tmp_path):
    count = find_problem("count")
    assert "kata/count.svg" in kata_page(count)["statement"]
    assert "<img" not in kata_page(replace(count, folder=tmp_path))["statement"]


def test_a_card_that_counts_has_buttons_and_one_that_asks_for_a_number_a_field():
    found = _cards([find_problem("crossings"), find_problem("count")], [])
    counted = [each for each in found if [one["text"] for one in each["options"]][-1:] == ["none"]]
    assert counted
    assert all(sum(one["right"] for one in each["options"]) == 1 for each in counted)
    numbers = [each for each in found if each["number"]]
    assert numbers
    assert all(each["typed"] and not each["options"] for each in numbers)
    assert any(not each["options"] and not each["typed"] for each in found)  # said aloud


def test_a_foreign_statement_brings_no_markup():
    links = "[a](javascript:alert(1)) [b](https://b.c)"
    found = markdown(f"# <img src=x onerror=alert(1)>\n\n<script>alert(1)</script>\n\n{links}")
    assert "<script" not in found
    assert "<img" not in found
    assert "javascript" not in found
    assert '<a href="https://b.c" rel="noopener">b</a>' in found
