"""`judge export`: what is written, what is replaced and refused, and what the tools say."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from judge.cli.app import app
from judge.packs.metadata import Version, uuid_of
from judge.schema import schema_of

pytestmark = pytest.mark.slow

BARE = ("export", "middle", "--out", "packages", "--wrong", "0")
LEGACY, NEW = Path("packages/legacy/middle"), Path("packages/2025-09/middle")


def validated(package: Path, case: str, output: bytes) -> int:
    """The exit status of a package's output validator."""
    folder = package / ("output_validators/exact" if package == LEGACY else "output_validator")
    base = package / "data" / case
    words = [sys.executable, folder / "validate.py", f"{base}.in", f"{base}.ans", f"{Path.cwd()}/"]
    return subprocess.run(words, input=output, check=False).returncode


def test_both_versions_with_programs_in_the_folder_of_their_verdict(judge):
    done = judge("export", "middle", "--out", "packages", "--zip", "--json")
    assert done.status == 0, done
    said = json.loads(done.out)
    Draft202012Validator(schema_of(app.get_command(None, "export"))).validate(said)
    assert {each["file"]: each["verdict"] for each in said["programs"]} == {
        "accepted/mean.py": "AC",
        "accepted/program.py": "AC",
        "wrong_answer/floor-division.py": "WA",
    }
    for package, version in ((LEGACY, Version.LEGACY), (NEW, Version.NEW)):
        yaml = (package / "problem.yaml").read_text()
        assert f"uuid: {uuid_of('middle', version)}\n" in yaml
        assert "license: unknown\n" in yaml
        assert "memory: 1024\n" in yaml
        assert (package / "submissions/wrong_answer/floor-division.py").is_file()
        (statement,) = package.glob("*/problem.en.tex")
        assert "the answers in the same order, one on a line" in statement.read_text()
        for case in ("sample/01-examples", "secret/02-whole", "secret/03-half"):
            base = package / "data" / case
            given = base.with_suffix(".in").read_bytes()
            right = base.with_suffix(".ans").read_bytes()
            assert validated(package, case, right) == 42
            assert validated(package, case, right.replace(b".", b".1", 1) + b"0\n") == 43
            # `.5` and `1.`, as bc and numpy print
            bare = re.sub(rb"(?m)^(-?)0(?=\.[1-9])|(?<=[0-9]\.)0$", rb"\1", right)
            assert bare != right or case == "secret/03-half"
            assert validated(package, case, bare) == 42
            words = [sys.executable, package / "input_validators/validate.py"]
            assert subprocess.run(words, input=given, check=False).returncode == 42
            assert subprocess.run(words, input=given + b"1 1\n", check=False).returncode == 43
            own = [sys.executable, package / "submissions/accepted/mean.py"]
            printed = subprocess.run(own, input=given, stdout=subprocess.PIPE, check=True).stdout
            assert validated(package, case, printed) == 42
    assert (NEW / "data/test_group.yaml").is_file()
    with zipfile.ZipFile("packages/domjudge/middle.zip") as archive:
        assert b"timelimit=1\n" in archive.read("domjudge-problem.ini")
        assert archive.getinfo("output_validators/exact/run").external_attr >> 16 & 0o111
    with zipfile.ZipFile("packages/legacy/middle.kpp") as archive:
        assert "middle/problem.yaml" in archive.namelist()
    for package in ("packages/legacy/middle", "packages/legacy/middle.kpp"):
        refused = judge("run", package, "a.py")
        assert (refused.status, refused.err.count("\n")) == (2, 1)


def test_a_package_of_the_problem_is_replaced_whole_and_nothing_else(judge):
    assert judge(*BARE).status == 0
    (LEGACY / "stray.txt").write_text("left over")
    before = (LEGACY / "problem.yaml").read_bytes()
    assert judge(*BARE).status == 0
    assert not (LEGACY / "stray.txt").exists()
    assert (LEGACY / "problem.yaml").read_bytes() == before
    assert not list(LEGACY.parent.glob(".judge-*"))

    (NEW / "problem.yaml").write_text("uuid: another\n")
    refused = judge(*BARE)
    assert refused.status == 2
    assert refused.err == (
        f"judge: {NEW}: it is not a package of this kata; name another folder with --out, or move it away\n"
    )
    assert (NEW / "problem.yaml").read_text() == "uuid: another\n"


def test_two_problems_of_one_short_name_are_refused(judge, pack, tmp_path):
    for name in ("mid-dle", "middle"):
        shutil.copytree(pack / "problems/middle", tmp_path / "pack/problems" / name)
    refused = judge(
        "export", "mid-dle", "middle", "--problems", tmp_path / "pack/problems", "--out", "packages"
    )
    assert refused.status == 2
    assert "mid-dle and middle would both be the package middle" in refused.err
    assert not Path("packages").exists()


def test_a_program_that_the_package_accepts_or_cannot_run_is_left_out(judge, pack, tmp_path):
    folder = tmp_path / "pack"
    shutil.copytree(pack, folder)
    wrong = folder / "solutions/middle/wrong"
    (wrong / "as-it-should.py").write_text(
        '"""no-mistake\n\nNone."""\n\n\ndef middle(a, b):\n    return (a + b) / 2\n'
    )
    (wrong / "with-numpy.py").write_text('"""with-numpy\n\nIt is."""\nimport numpy\nmiddle = numpy.mean\n')
    (wrong / "crash.py").write_text(
        '"""crash\n\nIt does."""\n\n\ndef middle(a, b):\n    return 1 / (a - a)\n'
    )
    done = judge("export", "middle", "--problems", folder / "problems", "--out", "packages", "--json")
    said = json.loads(done.out)
    assert {each["file"]: each["why"] for each in said["programs_left_out"]} == {
        "no-mistake": "as a program it is accepted",
        "with-numpy": "it imports numpy",
    }
    assert {"file": "run_time_error/crash.py", "verdict": "RTE", "test": "01-examples"} in said["programs"]
