"""Files that no transcript can hold: links, names that steer a terminal, what is too large or locked.

What else a caller gets wrong is in the transcripts of `refused/`.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from cli_support import MEAN

pytestmark = pytest.mark.slow


def refused(ended, *words):
    assert ended.status == 2, ended
    assert ended.out == ""
    assert ended.err.count("\n") == 1, ended.err
    assert ended.err.startswith("judge: ")
    for word in words:
        assert word in ended.err


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["run", "middle", "a\0b"], "no such file"),
        (["init", "middle", "a\0b"], "cannot be written"),
        (["init", "middle", "x" * 3000], "cannot be written (file name too long)"),
        (["report", "--out", "x" * 300], "cannot be written (file name too long)"),
        (["new", "pack", "a" * 300], "cannot be written (file name too long); name another folder"),
    ],
)
def test_a_name_no_file_can_have(words, told, judge, submit):
    judge("run", "middle", submit(MEAN), "-q")
    refused(judge(*words), told)
    assert [path.name for path in Path().iterdir()] == ["mine.py"]


def test_a_file_too_large_to_be_a_program(judge, submit):
    refused(judge("run", "middle", submit(b"#" * (5 * 2**20))), "larger than 4 MB")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_what_may_not_be_read(judge, submit):
    Path(submit(MEAN)).chmod(0)
    refused(judge("run", "middle", "mine.py"), "cannot be read (permission denied)", "check its permissions")
    folder = Path(submit(MEAN, "team/mine.py")).parent
    folder.chmod(0)
    try:
        refused(judge("run", "middle", "team"), "team: cannot be read (permission denied)")
    finally:
        folder.chmod(0o755)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("run middle mine.py --svg closed/out", "closed/out: cannot be written"),
        ("run middle mine.py --junit closed/out", "closed/out: cannot be written"),
        ("run middle mine.py --save-regression closed/out", "closed/out: cannot be written"),
        ("report --out closed/out", "cannot be written (permission denied)"),
        ("new closed/pack mine", "cannot be written (permission denied)"),
    ],
)
def test_a_folder_that_may_not_be_written_is_told_of_before_anything_is_done(words, told, judge, submit):
    judge("run", "middle", submit(MEAN), "-q")
    Path("closed").mkdir(mode=0o555)
    refused(judge(*words.split()), told)
