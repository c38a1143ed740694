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
from sampling import daily
from screenshot import FILM, real_loop, text_of
from walk import ROOT, WALKS, claims_hold, go, missing, plain, steps

from judge.cli import main
from judge.errors import ExitCode
from judge.problem import Verdict
from judge.problem.find import sound_problems

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
        assert command.endswith(" && . .venv/bin/activate && judge")
    else:
        assert "[test]" in command
        assert command.endswith(".venv/bin/pytest -n auto --dist loadfile")


def test_every_kata_is_in_readme(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    for problem in sound_problems()[0]:
        assert re.search(rf"^\| .*`{problem.id}`", README, re.MULTILINE)


@pytest.mark.skipif(not FOLDER.exists(), reason="not part of a source distribution")
@pytest.mark.parametrize("level", daily(levels(), ["junior"]))
def test_the_pictures_of_the_katas_are_as_they_are_drawn_now(level):
    assert f"![{level}]({path_of(level).relative_to(ROOT).as_posix()})" in README
    kept = path_of(level).read_text(encoding="utf-8")
    assert kept == gallery(level, levels()[level]), "python tests/packaging/gallery.py draws them anew"


def test_exit_codes_and_verdicts():
    scripts, failures = (
        (MANUAL / f"{name}.md").read_text(encoding="utf-8") for name in ("scripts", "failures")
    )
    for code in ExitCode:
        assert re.search(rf"^\| {code.value} \|", scripts, re.MULTILINE)
    for verdict in Verdict:
        assert f"- `{verdict.value}` " in failures


def test_links_from_readme_reach_every_page_of_the_manual():
    reached, ahead = set(), {ROOT / "README.md"}
    while ahead:
        path = ahead.pop()
        reached.add(path)
        links = re.findall(r"\]\(([^)#:]+\.md)[)#]", path.read_text(encoding="utf-8"))
        ahead |= {found for link in links if (found := (path.parent / link).resolve()).exists()} - reached
    assert set(MANUAL.glob("*.md")) <= reached


@pytest.mark.nightly
@pytest.mark.parametrize(("walk", "statuses"), [(WALKS[2], [0]), (WALKS[4], [0, 1, 0, 0])])
def test_the_manuals_walks_go_as_told(walk, statuses, tmp_path):
    name, title = walk
    taken = go(steps((ROOT / name).read_text(encoding="utf-8"), title), tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == statuses


def test_the_tour_goes_as_told(tmp_path):
    walk = steps(README, TOUR)
    taken = go(walk, tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 1]


@pytest.mark.skipif(not FILM.exists(), reason="not part of a source distribution")
def test_the_film_shows_a_try_a_hint_and_an_accepted_try_and_loads_nothing():
    film = FILM.read_text(encoding="utf-8")
    assert "loop.svg" in README
    assert not re.findall(r"(?<!xmlns=.)https?:|@font-face|<script|<image|url\((?!#)", film)
    shown = re.findall(r"Smallest failing case|hint 1 of|Accepted", film)
    assert shown == ["Smallest failing case", "hint 1 of", "Accepted"]


@pytest.mark.nightly
@pytest.mark.skipif(not FILM.exists(), reason="not part of a source distribution")
def test_the_film_begins_with_a_run_as_it_goes_now(built):
    first = re.search(r"(?s)<svg width.*?</svg>", FILM.read_text(encoding="utf-8"))
    lacking = missing(plain(text_of(first[0])), plain(real_loop(built, 1)[0]))
    assert lacking is None, f"python tests/packaging/screenshot.py draws it anew; it lacks\n{lacking}"


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("place", "wanted"), [(0, r"alice.py AC 100 \nbob.py WA \d+ tangent-twice\n"), (1, "")]
)
def test_the_programs_that_judge_do_as_told(place, wanted, tmp_path, built):
    blocks = re.findall(r"(?ms)^```py\n(.*?)^```$", (MANUAL / "testing.md").read_text(encoding="utf-8"))[2:]
    assert len(blocks) == 2
    homework = tmp_path / "homework"
    homework.mkdir()
    shutil.copy(ROOT / "solutions" / "segment" / "accepted" / "tolerant.py", homework / "alice.py")
    (homework / "bob.py").write_bytes(mistaken("segment", "tangent-twice"))
    (tmp_path / "marks.py").write_text(blocks[place], encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "JUDGE_CACHE": str(built)}
    command = [sys.executable, "marks.py"]
    ended = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300
    )
    assert (ended.returncode, ended.stderr) == (0, "")
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
    """What the judge really writes, read as the task in the manual reads it."""
    blocks = re.findall(r"(?ms)^```json\n(.*?)^```$", (MANUAL / "scripts.md").read_text(encoding="utf-8"))
    (block,) = [each for each in blocks if "problemMatcher" in each]
    (task,) = json.loads(block)["tasks"]
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "mine.py").write_text(f"def middle(a, b){body}\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
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


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page):
    path = ROOT / page
    if not path.exists():
        pytest.skip("not part of a source distribution")
    for target in re.findall(r"\]\(([^)#]+)\)", path.read_text(encoding="utf-8")):
        if not target.startswith("http"):
            assert (path.parent / target).exists(), target
