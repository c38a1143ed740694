"""The isolation level that `judge doctor` found is demanded by the commands after it."""

from __future__ import annotations

import json
import os

import pytest
from cli_support import MEAN

from judge.judging.isolation import keep_level, kept_level
from judge.sandbox import levels, probe

pytestmark = pytest.mark.slow

BEST = next(level.name for level in levels() if level.available)


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    folder = tmp_path / "own-cache"
    monkeypatch.setenv("JUDGE_CACHE", str(folder))
    return folder


@pytest.fixture
def bare(tmp_path):
    """A PATH without bubblewrap."""
    if BEST != "full":
        pytest.skip("full cannot be had here")
    (tmp_path / "bin").mkdir()
    return str(tmp_path / "bin")


@pytest.mark.usefixtures("own_cache")
def test_bubblewrap_is_removed_and_nothing_drops_in_silence(process, submit, tmp_path, bare):
    file = str(tmp_path / submit(MEAN))
    assert process("doctor").lines[-1] == "isolation is full"
    ended = process("run", "middle", file, file, "--json", PATH=bare)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == (
        "judge: isolation full, which 'judge doctor' found here, cannot be had: bubblewrap is not installed; "
        "install bubblewrap, or let 'judge doctor' look again\n"
    )
    for level in ("strong", "limits"):
        ended = process("run", "middle", file, "--json", "--isolation", level, PATH=bare)
        assert (ended.status, ended.err) == (0, "")
        assert json.loads(ended.out)["isolation"] == level
    assert process("verify", "middle", PATH=bare).status == 2
    assert process("doctor", PATH=bare).lines[-1] == "isolation is strong"
    ended = process("run", "middle", file, "--json", PATH=bare)
    assert (ended.status, ended.err, json.loads(ended.out)["isolation"]) == (0, "", "strong")
    ended = process("run", "middle", file, "--json")
    assert (ended.status, ended.err, json.loads(ended.out)["isolation"]) == (0, "", "full")


def test_the_doctor_keeps_what_it_found(judge, own_cache):
    assert kept_level() is None
    assert judge("doctor").status == 0
    assert kept_level() == BEST
    (file,) = (own_cache / "isolation").iterdir()
    file.write_bytes(file.read_bytes().replace(BEST.encode(), b"limits"))
    assert kept_level() is None, "nobody else writes it"
    assert judge("doctor").status == 0
    assert kept_level() == BEST


@pytest.mark.usefixtures("own_cache")
def test_a_shortage_while_the_doctor_looks_lowers_nothing(judge, monkeypatch):
    keep_level("full")
    found = (
        probe.Level("full", available=False, meaning="", why_not="no memory", lasting=False),
        probe.Level("strong", available=True, meaning=""),
        probe.Level("limits", available=True, meaning=""),
    )
    monkeypatch.setattr("judge.cli.commands.doctor.levels", lambda _hide: found)
    assert judge("doctor").lines[-1] == "isolation is strong"
    assert kept_level() == "full"
    monkeypatch.setattr(
        "judge.cli.commands.doctor.levels", lambda _hide: (found[0]._replace(lasting=True), *found[1:])
    )
    judge("doctor")
    assert kept_level() == "strong"


@pytest.mark.usefixtures("own_cache")
def test_what_was_found_elsewhere_or_by_somebody_else_does_not_count(monkeypatch):
    keep_level("full")
    here = os.uname()
    for name, other in (
        ("uname", lambda: os.uname_result(("Linux", "elsewhere", *here[2:]))),
        ("uname", lambda: os.uname_result((*here[:2], "another kernel", *here[3:]))),
        ("geteuid", lambda: 12345),
    ):
        with monkeypatch.context() as patch:
            patch.setattr(os, name, other)
            assert kept_level() is None
    with monkeypatch.context() as patch:
        patch.setattr("judge.judging.isolation.__version__", "99")
        assert kept_level() is None
    assert kept_level() == "full"
    with monkeypatch.context() as patch:  # a folder that two machines share keeps a level of each
        patch.setattr(os, "uname", lambda: os.uname_result(("Linux", "elsewhere", *here[2:])))
        keep_level("strong")
    assert kept_level() == "full"
