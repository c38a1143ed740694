"""Beginning a kata, the one in hand, hints, the next one, a solution: what is kept, and where files are.

What these commands show is in the transcripts of `kata/`.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys

import pytest
from cli_support import FLOOR, MEAN, ROOT

from judge.kata.history import History


def refused(ended, *words):
    assert (ended.status, ended.out) == (2, ""), ended
    assert ended.err.count("\n") == 1, ended.err
    for word in words:
        assert word in ended.err


FULL = """
import resource, sys
sys.dont_write_bytecode = True  # half a compiled module would break every process after this one
resource.setrlimit(resource.RLIMIT_FSIZE, (200, resource.RLIM_INFINITY))
sys.argv = ["judge", "init", "middle"]
from judge.cli import main
main()
"""


@pytest.mark.slow
def test_init_that_runs_out_of_room_leaves_no_half_of_a_file(tmp_path):
    command = [sys.executable, "-c", FULL]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    ended = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert ended.returncode == 2
    assert ended.stderr == "judge: middle.py: cannot be written (file too large); name another file\n"
    assert list(tmp_path.iterdir()) == []


def test_the_kata_in_hand_is_judged_from_any_folder(judge, submit, tmp_path, monkeypatch):
    judge("init", "middle")
    submit(MEAN, "middle.py")
    (tmp_path / "deeper").mkdir()
    monkeypatch.chdir(tmp_path / "deeper")
    assert f"{tmp_path / 'middle.py'}  middle" in judge("run").out
    (tmp_path / "middle.py").unlink()
    refused(judge("run"), "middle.py", "'judge init middle")


def test_what_was_seen_of_hints_and_solutions_is_kept(judge, submit):
    judge("hint", "middle")
    judge("hint", "middle", "--step", "2")
    judge("hint", "middle", "--step", "1")
    assert judge("solution", "middle", "--give-up").status == 0
    assert judge("solution", "middle").status == 0  # it is known now
    assert judge("solution", "middle", "--give-up").status == 0
    with History.open() as history:
        assert history.hints_seen("middle") == 2
        assert history.gave_up("middle")
        assert [each.hints for each in history.helps("middle")] == [1, 2, 0]


@pytest.fixture
def two_ways(pack, tmp_path, monkeypatch):
    """A pack whose problem `middle` has two approaches, which are timed."""
    shutil.copytree(pack, tmp_path / "ways")
    accepted = tmp_path / "ways" / "solutions" / "middle" / "accepted"
    (accepted / "half_way.py").write_text(
        '"""from-a-on\n\nHalf of the way from a to b. Then on.\n"""\n\n\n'
        "def middle(a, b):\n    return a + (b - a) / 2\n"
    )
    toml = tmp_path / "ways" / "problems" / "middle" / "problem.toml"
    rule = '[time]\nlimit = 1000\nfunction = "mean.py"\n\n'
    toml.write_text(toml.read_text().replace("[tolerance]", f"{rule}[tolerance]", 1))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "ways" / "problems"))
    monkeypatch.setenv("COLUMNS", "80")


TABLE = """\
  approach  × reference  idea
  mean              1.0  the one above
  half-way           12  Half of the way from a to b.
  yours                  run 1, mine.py

  judge solution middle half-way  shows another one
"""


def test_the_approaches_stand_side_by_side_with_yours(judge, submit, two_ways, monkeypatch):
    assert judge("run", "-q", "middle", submit(MEAN)).status == 0
    asked = []

    def paces(problem, programs, bars):
        asked.extend((problem.id, name, source.decode()) for name, source in programs)
        return [1.0, 12.3, None]  # so that nothing depends on how busy the machine is

    monkeypatch.setattr("judge.judging.pace.paces", paces)
    ended = judge("solution", "middle")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out.endswith(f"\n```\n\n{TABLE}")
    assert [name for _, name, _ in asked] == ["mean.py", "half_way.py", "mine.py"]
    assert asked[2][2] == MEAN
    told = json.loads(judge("solution", "middle", "--json").out)
    assert [each["ratio"] for each in told["approaches"]] == [1.0, 12.3]
    assert told["yours"] == {"run": 1, "file": "mine.py", "ratio": None}


def test_times_that_cannot_be_measured_cost_a_line(judge, two_ways, tmp_path):
    (tmp_path / "ways" / "problems" / "middle" / "problem.py").write_text("BUILDERS = {}\n")
    ended = judge("solution", "middle", "--give-up")
    assert ended.status == 0
    assert ended.err.startswith("judge: the times are not measured: ")
    assert len(ended.err.splitlines()) == 1
    assert "reference" not in ended.out


def test_what_is_written_is_said_before_it_is(judge, tmp_path):
    words = ("next", "--init")
    usual = ("distance_squared", "middle")  # whichever of them comes first
    for name in usual:
        (tmp_path / f"{name}.py").symlink_to("elsewhere.py")  # no file yet, and none can be made there
    ended = judge(*words)
    assert ended.status == 2
    assert re.fullmatch(r"Writing \w+\.py, which is not there yet: the stub of [\w-]+\.\n\n", ended.out), (
        ended.out
    )
    assert "the file is there already" in ended.err
    assert judge(*words, "--json").out == ""
    for name in usual:
        (tmp_path / f"{name}.py").unlink()
    ended = judge(*words)
    assert ended.lines[0].startswith("Writing ")
    assert (tmp_path / ended.lines[0].split()[1].rstrip(",")).is_file()


# -- a pack that only --problems finds -------------------------------------------------------------------


@pytest.fixture
def lone(pack, tmp_path, monkeypatch):
    """The folder of a pack that nothing but its name leads to."""
    monkeypatch.delenv("JUDGE_PROBLEMS")
    shutil.copytree(pack, tmp_path / "elsewhere" / "pack")
    return tmp_path / "elsewhere" / "pack" / "problems"


def test_a_packs_kata_is_gone_on_with_by_every_command(lone, judge, submit):
    assert judge("init", "middle", "--problems", lone).status == 0
    submit(FLOOR, "middle.py")
    assert judge("run", "-q").status == 1
    assert judge("hint").lines[0].endswith("middle, hint 1 of 3")
    submit(MEAN, "middle.py")
    assert judge("run", "-q").status == 0
    assert judge("solution").status == 0
    assert judge("next").status == 0


def test_a_kata_whose_pack_is_gone_says_where_it_was(lone, judge, tmp_path):
    judge("init", "middle", "--problems", lone)
    (tmp_path / "elsewhere" / "pack").rename(tmp_path / "moved")
    for words in (["run"], ["hint"], ["watch"]):
        refused(judge(*words), f"{lone}: the problem of the kata in hand, middle, is not there", "--problems")
    assert judge("run", "-q", "--problems", tmp_path / "moved" / "problems").status == 1
