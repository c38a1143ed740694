"""README and the other pages say what is so."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys

import pytest
from gallery import FOLDER, gallery, levels, path_of
from mistaken import mistaken
from screenshot import PICTURE, real_run, text_of
from walk import ROOT, WALKS, claims_hold, go, missing, plain, steps

from judge.cli import main
from judge.errors import ExitCode
from judge.problem import Verdict
from judge.problem.find import all_problems

MANUAL = ROOT / "judge" / "manual"
PAGES = (
    "README.md",
    ".github/CONTRIBUTING.md",
    ".github/CHANGELOG.md",
    "tests/README.md",
    *(f"judge/manual/{path.name}" for path in sorted(MANUAL.glob("*.md"))),
)
TOUR = WALKS[0][1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["judge", "tests"])
def test_the_two_commands_are_one_line_each_and_set_themselves_up(name):
    ((command,),) = [re.findall(rf"<!-- {name} -->\n```sh\n(.*)\n```", README)]
    assert command.startswith("python3 -m venv .venv && .venv/bin/pip install ")
    if name == "judge":
        assert "in count segment ray-nearest exact-count; do .venv/bin/judge run -q $p" in command
        assert command.endswith('judge init which-side"')
    else:
        assert "[test]" in command
        assert command.endswith(".venv/bin/pytest -n auto --dist loadfile")


def test_every_kata_is_in_readme_and_with_its_signature_in_the_manual(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    told = (MANUAL / "katas.md").read_text(encoding="utf-8")
    for problem in all_problems():
        signature = f"{problem.entry}({', '.join(parameter.name for parameter in problem.parameters)})"
        assert f"| `{problem.id}` | {problem.tier.value} | `{signature}` |" in told
        assert re.search(rf"^\| .*`{problem.id}`", README, re.MULTILINE)


@pytest.mark.parametrize("level", levels())
def test_the_pictures_of_the_katas_are_as_they_are_drawn_now(level):
    if not FOLDER.exists():
        pytest.skip("not part of a source distribution")
    assert f"![{level}]({path_of(level).relative_to(ROOT).as_posix()})" in README
    kept = path_of(level).read_text(encoding="utf-8")
    assert kept == gallery(level, levels()[level]), "python tests/packaging/gallery.py draws them anew"


def test_every_kata_has_its_picture():
    shown = [kata for katas in levels().values() for kata in katas]
    assert sorted(shown) == sorted(
        each.id for each in all_problems() if each.folder.parent == ROOT / "problems"
    )


def test_exit_codes_and_verdicts():
    page = (MANUAL / "scripts.md").read_text(encoding="utf-8")
    for code in ExitCode:
        assert re.search(rf"^\| {code.value} \|", page, re.MULTILINE)
    for verdict in Verdict:
        assert f"`{verdict.value}`" in page


def test_readme_is_for_the_first_ten_minutes_and_names_every_page_of_the_manual():
    assert README.count("\n") <= 250
    for path in MANUAL.glob("*.md"):
        assert f"[{path.stem}](judge/manual/{path.name})" in README


def test_a_program_is_judged_as_the_manual_tells(tmp_path):
    name, title = WALKS[2]
    taken = go(steps((ROOT / name).read_text(encoding="utf-8"), title), tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0]


@pytest.fixture(scope="module")
def screenshot():
    if not PICTURE.exists():
        pytest.skip("not part of a source distribution")
    return PICTURE.read_text(encoding="utf-8")


def test_the_tour_goes_as_told(tmp_path):
    walk = steps(README, TOUR)
    taken = go(walk, tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken if each.step.words == "judge run"] == [1, 0]
    assert (tmp_path / "judge-report.html").read_text(encoding="utf-8").startswith("<!doctype html>")


def test_the_tour_shows_every_stage():
    shown = "".join(f"$ {step.words}\n{step.text}" for step in steps(README, TOUR) if not step.is_file)
    for stage in ("init", "run", "hint", "solution", "next", "progress", "due", "report"):
        assert f"$ judge {stage}" in shown
    for part in (
        "smallest case found",
        "True scale",
        "likely, score",
        "WA  interview level passed",
        "wrong answer",
        "AC  accepted",
    ):
        assert part in shown


def test_the_picture_is_of_a_run_as_it_goes_now(screenshot, built):
    lacking = missing(plain(text_of(screenshot)), plain(real_run(built)))
    assert lacking is None, f"python tests/packaging/screenshot.py draws it anew; it lacks\n{lacking}"


def test_the_picture_loads_nothing_and_holds_on_any_ground(screenshot):
    assert "screenshot.svg" in README
    assert not re.findall(r"(?<!xmlns=.)https?:|@font-face|<script|<image|url\((?!#)", screenshot)
    assert re.search(r"<rect fill=\"#0d1117\"", screenshot)
    assert re.search(r"[\u2801-\u28ff]", screenshot)
    assert re.search(r"[\w-]+  likely, score", text_of(screenshot))


def python_blocks(name):
    """The programs that a page of the manual shows."""
    return re.findall(r"(?ms)^```py\n(.*?)^```$", (MANUAL / name).read_text(encoding="utf-8"))


@pytest.fixture
def homework(tmp_path):
    """Two submissions in a folder, beside which a program of the page can be run."""
    folder = tmp_path / "homework"
    folder.mkdir()
    solutions = ROOT / "solutions" / "segment"
    shutil.copy(solutions / "accepted" / "geometric.py", folder / "alice.py")
    (folder / "bob.py").write_bytes(mistaken("segment", "tangent-twice"))
    return tmp_path


@pytest.mark.parametrize("place", [0, 1])
def test_the_programs_that_judge_do_as_told(place, homework, built):
    blocks = python_blocks("library.md")
    assert len(blocks) == 2
    (homework / "marks.py").write_text(blocks[place], encoding="utf-8")
    command = [sys.executable, "marks.py"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "JUDGE_CACHE": str(built)}
    ended = subprocess.run(
        command, cwd=homework, env=environment, capture_output=True, text=True, timeout=300
    )
    assert (ended.returncode, ended.stderr) == (0, "")
    wanted = r"alice.py AC 100 \nbob.py WA \d+ tangent-twice\n" if place == 0 else ""
    assert re.fullmatch(wanted, ended.stdout), ended.stdout


@pytest.mark.parametrize(
    ("body", "place", "said"),
    [
        (":\n    return a", None, "WA"),
        (":\n    x = 1\n    return x / 0", "3", "RTE"),
        ("\n    return a", "1", "CE"),
    ],
)
def test_the_task_for_vs_code_finds_a_failure_at_its_line(body, place, said, tmp_path, monkeypatch, capsys):
    """What the judge really writes, read as README's task reads it."""
    (block,) = [each for each in re.findall(r"(?ms)^```json\n(.*?)^```$", README) if "problemMatcher" in each]
    (task,) = json.loads(block)["tasks"]
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "mine.py").write_text(f"def middle(a, b){body}\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JUDGE_PROBLEMS", str(ROOT / "tests" / "fixtures" / "pack" / "problems"))
    name, *words = shlex.split(task["command"].replace("${relativeFile}", "src/mine.py"))
    monkeypatch.setattr(sys, "argv", [name, *words, "--no-history"])
    with pytest.raises(SystemExit) as ended:
        main()
    out, err = capsys.readouterr()
    assert (name, ended.value.code, err) == ("judge", 1, "")
    pattern = task["problemMatcher"]["pattern"]
    found = [re.match(pattern["regexp"], line) for line in out.splitlines()]
    assert found
    assert all(found), out
    first, *others = found
    assert (first[pattern["file"]], first[pattern["severity"]]) == ("src/mine.py", "error")
    assert place in (None, first[pattern["line"]])
    assert first[pattern["message"]].split(" ")[0].rstrip(":") == said
    assert {each[pattern["severity"]] for each in others} <= {"note"}


def prose(page):
    """The lines of a page outside its blocks."""
    parts = re.split(r"^```.*$", page, flags=re.MULTILINE)
    return [line for part in parts[::2] for line in part.splitlines()]


@pytest.mark.parametrize("page", PAGES)
def test_no_line_stands_twice_and_none_is_long(page):
    """A merge leaves doubles behind."""
    if not (ROOT / page).exists():
        pytest.skip("not part of a source distribution")
    lines = prose((ROOT / page).read_text(encoding="utf-8"))
    assert [line for line in lines if len(line) > 120 and not line.startswith("|")] == []
    below = [*lines[1:], ""]
    told = [
        line
        for line, after in zip(lines, below, strict=True)
        if len(line) > 30 and not after.startswith("|--")  # tables may have the same head
    ]
    assert [line for line in told if told.count(line) > 1] == []
    firsts = re.findall(r"^\| (`judge [^|]*) \|", "\n".join(lines), re.MULTILINE)
    assert len(firsts) == len(set(firsts))


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page):
    path = ROOT / page
    if not path.exists():
        pytest.skip("not part of a source distribution")
    for target in re.findall(r"\]\(([^)#]+)\)", path.read_text(encoding="utf-8")):
        if not target.startswith("http"):
            assert (path.parent / target).exists(), target
