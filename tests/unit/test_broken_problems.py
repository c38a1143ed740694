"""Each of the broken problems is refused with one line that says what, where and what to do."""

from __future__ import annotations

import re
import shutil

import pytest
from broken_problems import FAULTS, SOUND, broken

from judge.data import load_data
from judge.errors import ExitCode, ProblemError
from judge.problem.load import load_problem


def refused(folder, place, what, remedy):
    with pytest.raises(ProblemError) as caught:
        load_data(load_problem(folder), cache=False)
    error = caught.value
    assert error.where == f"{folder.name}/{place}"
    assert what in error.what
    assert remedy in (error.remedy or "")
    assert re.fullmatch(r"[^\n]{20,300}", str(error))
    assert error.exit_code is ExitCode.FAULT


def test_what_they_are_made_of_is_sound():
    assert len(load_data(load_problem(SOUND), cache=False).groups) == 2


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_a_broken_problem_is_refused_in_one_line(name, tmp_path):
    fault = FAULTS[name]
    refused(broken(name, tmp_path), fault["place"], fault["what"], fault["remedy"])


def test_a_file_that_is_not_utf8_is_refused(tmp_path):
    folder = tmp_path / "not-utf8"
    shutil.copytree(SOUND, folder)
    toml = folder / "problem.toml"
    toml.write_bytes(toml.read_bytes().replace(b"Square", b"Sq\xe4are"))
    refused(folder, "problem.toml", "byte 11 is not UTF-8", "save the file as UTF-8")
