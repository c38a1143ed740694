"""What the caller gets wrong: status 2, nothing on standard output, one line that says what to do."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from cli_support import MEAN


def refused(ended, *words):
    assert ended.status == 2, ended
    assert ended.out == ""
    assert ended.err.count("\n") == 1, ended.err
    assert ended.err.startswith("judge: ")
    for word in words:
        assert word in ended.err


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (["rnu"], "did you mean 'run'?"),
        (["qqq"], "the commands are init, run"),
        (["--hepl"], "did you mean '--help'?"),
        (["run"], "begin one with 'judge init PROBLEM'"),
        (["run", "middle"], "missing argument 'FILE'"),
        (["run", "middle", "mine.py", "--jsn"], "did you mean '--json'?"),
        (["run", "middle", "mine.py", "--seed", "x"], "'x' is not a valid integer"),
        (["run", "middel", "mine.py"], "did you mean 'middle'?"),
        (["run", "middle", "mine.py", "--group", "hlaf"], "did you mean 'half'?"),
        (["run", "middle", "mine.py", "--group", "zzz"], "it has examples, whole, half"),
        (["run", "mine.py", "middle"], "the problem comes first"),
        (["run", "problems/middle", "mine.py"], "give its id, and the folder it is in with --problems"),
        (["run", "middle", ""], "'': no such file"),
        (["run", "middle", "mien.py"], "did you mean mine.py?"),
        (["run", "middle", "nowhere/mine.py"], "there is no folder nowhere"),
        (["run", "middle", "mine.py", "--problems", "nowhere"], "nowhere is not a folder"),
        (["show", "middel"], "did you mean 'middle'?"),
        (["data", "middle"], "missing option '--out'"),
        (["data", "middle", "--out", "mine.py"], "it is a file, not a folder"),
        (["verify", "middel"], "did you mean 'middle'?"),
    ],
)
def test_one_line_names_the_fault_and_the_remedy(words, wanted, judge, submit):
    submit(MEAN)
    refused(judge(*words), wanted)


def test_in_json_mode_too(judge, submit):
    submit(MEAN)
    refused(judge("run", "middle", "missing.py", "--json"), "missing.py: no such file")


def test_all_files_are_looked_at_before_the_first_is_judged(judge, submit):
    name = submit(MEAN)
    refused(judge("run", "middle", name, "other.py", "--json"), "other.py: no such file")


def test_a_folder_without_programs(judge, submit, tmp_path):
    (tmp_path / "empty").mkdir()
    refused(judge("run", "middle", "empty"), "empty: this folder holds no *.py file")


def test_a_name_no_file_can_have(judge, submit):
    refused(judge("run", "middle", "a\0b"), "no such file")


def test_a_name_that_steers_the_terminal_is_written_out(judge, submit):
    ended = judge("run", "middle", "\x1b[31mred.py")
    refused(ended, r"\x1b[31mred.py")
    assert "\x1b" not in ended.err


def test_no_ordinary_file(judge, submit):
    refused(judge("run", "middle", "/dev/null"), "/dev/null: this is no ordinary file")


def test_a_file_too_large_to_be_a_program(judge, submit):
    name = submit(b"#" * (5 * 2**20))
    refused(judge("run", "middle", name), "larger than 4 MB")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_an_unreadable_file(judge, submit):
    name = submit(MEAN)
    Path(name).chmod(0)
    refused(judge("run", "middle", name), "cannot be read (permission denied)", "check its permissions")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_an_unreadable_folder(judge, submit):
    folder = Path(submit(MEAN, "team/mine.py")).parent
    folder.chmod(0)
    try:
        refused(judge("run", "middle", "team"), "team: cannot be read (permission denied)")
    finally:
        folder.chmod(0o755)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
@pytest.mark.parametrize("option", ["--svg", "--junit", "--save-regression"])
def test_a_folder_that_cannot_be_written_is_told_of_before_anything_is_judged(option, judge, submit):
    name = submit(MEAN)
    Path("closed").mkdir(mode=0o555)
    refused(judge("run", "middle", name, option, "closed/out"), "closed/out: cannot be written", option)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("mien.py", "mine.py"), ("mine", "mine.py"), ("mine.pyy", "mine.py"), ("other.py", "")],
)
def test_a_missing_file_is_taken_for_one_of_a_like_name_only(typed, meant, judge, submit):
    submit(MEAN)
    ended = judge("run", "middle", typed)
    refused(ended, f"{typed}: no such file")
    assert (f"did you mean {meant}?" in ended.err) if meant else ("did you mean" not in ended.err)


def test_a_link_that_leads_nowhere_is_called_one(judge, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link.py").symlink_to("nowhere.py")
    ended = judge("run", "middle", "link.py")
    assert ended.status == 2
    assert ended.err == "judge: link.py: no such file; it is a link to a file that is not there\n"


def test_a_file_in_place_of_a_command_is_one_to_run(judge, submit):
    ended = judge(submit("x = 1\n", "mine.py"))
    assert (ended.status, ended.out) == (2, "")
    assert (
        ended.err
        == "judge: no such command 'mine.py'; to judge that file: judge run mine.py; see 'judge --help'\n"
    )
    spaced = judge(submit("x = 1\n", "my own.py"))
    assert spaced.err.endswith("to judge that file: judge run 'my own.py'; see 'judge --help'\n")
