"""Beginning a kata, the one in hand, hints, the next one, a solution: what is kept, and where files are.

What these commands show is in the transcripts of `kata/`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys

import pytest
from cli_support import FLOOR, MEAN, ROOT

from judge.kata.history import History

pytestmark = pytest.mark.slow


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
