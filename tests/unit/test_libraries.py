"""Real libraries in the judge: adapters, the table of what they come to, what to install for it."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import judge
from judge.data.libraries import library_table
from judge.manual import page
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.problem.solutions import SolutionKind, read_solutions, requirement
from judge.sandbox import Containment
from judge.verify.gate import fresh_data, verify_problem
from judge.verify.libraries import installed_version, measure_libraries, measured

TESTS = Path(__file__).parents[1]
ADAPTERS = sorted(TESTS.parent.glob("solutions/*/libraries/*.*"))
PINNED = ("ezdxf", "compas", "euclid3", "scikit_spatial", "pymunk")  # .ci/run installs them by night
ADAPTER = '''"""fakelib 1.0: roots

It counts the roots of what is positive."""
import fakelib

def root_count(c):
    return fakelib.roots(c)
'''


@pytest.fixture
def kata(tmp_path, monkeypatch):
    """A kata with an adapter, and a folder of packages with its library, which raises for c = -3."""
    for kind in ("problems", "solutions"):
        shutil.copytree(TESTS / "fixtures" / kind / "root-count", tmp_path / kind / "root-count")
    folder = tmp_path / "solutions" / "root-count" / "libraries"
    folder.mkdir()
    (folder / "fakelib.py").write_text(ADAPTER)
    packages = tmp_path / "packages"
    (packages / "fakelib-1.0.dist-info").mkdir(parents=True)
    (packages / "fakelib-1.0.dist-info" / "METADATA").write_text("Name: fakelib\nVersion: 1.0\n")
    (packages / "fakelib.py").write_text(
        "def roots(c):\n    if c == -3: raise ValueError(c)\n    return 2 * (c > 0)\n"
    )
    monkeypatch.setenv("JUDGE_PACKAGES", str(packages))
    return load_problem(tmp_path / "problems" / "root-count")


def table_of(kata):
    return measure_libraries(kata, fresh_data(kata), Containment(), lambda *_: None)


def run_of(kata, adapter: str) -> str:
    file = kata.solutions / "libraries" / adapter
    words = ["run", "--problems", str(kata.folder.parent), "root-count", str(file), "--no-history"]
    ended = subprocess.run(
        [sys.executable, "-m", "judge", *words], capture_output=True, text=True, check=False
    )
    return " ".join(ended.stdout.split())


def test_an_adapter_is_measured_and_its_row_is_kept(kata):
    found = table_of(kata)
    (row,) = found.libraries
    assert (row.library, row.version) == ("fakelib", "1.0")
    assert 0 < row.cases[0] < row.cases[1]
    assert row.groups[0] < row.groups[1]
    assert row.smallest == "-3 (small)"  # which raises
    assert library_table(kata) == found
    kept = json.loads((kata.folder / "libraries.json").read_text())
    assert kept["fakelib"]["cases"] == list(row.cases)


@pytest.mark.parametrize(
    ("version", "said"),
    [
        ("", "fakelib is not installed: pip install fakelib==1.0"),
        ("2.1", "fakelib 2.1 is installed, libraries/fakelib.py calls 1.0: pip install fakelib==1.0"),
    ],
)
def test_what_is_missing_or_too_new_is_one_line_and_the_row_stays(kata, tmp_path, version, said):
    before = table_of(kata).libraries
    old = tmp_path / "packages" / "fakelib-1.0.dist-info"
    if version:
        (old / "METADATA").write_text(f"Name: fakelib\nVersion: {version}\n")
        old.rename(old.with_name(f"fakelib-{version}.dist-info"))
    else:
        shutil.rmtree(old)
    after = table_of(kata)
    assert after.missing == (said,)
    assert after.libraries == before


def test_a_package_that_ends_its_import_is_one_line_and_the_row_stays(kata, tmp_path):
    before = table_of(kata).libraries
    (tmp_path / "packages" / "fakelib.py").write_text("raise ImportError('wants a display')\n")
    after = table_of(kata)
    said = "ImportError: wants a display (line 4) ends the import"
    assert after.missing == (f"fakelib 1.0 is not measured: {said}",)
    assert after.libraries == before
    assert f"{said}. It calls fakelib==1.0: pip install fakelib==1.0" in run_of(kata, "fakelib.py")


def test_an_adapter_that_raises_loses_that_case_alone(kata):
    result = judge.judge(kata, kata.solutions / "libraries" / "fakelib.py")
    (failing,) = [each for each in result.groups if each.verdict is Verdict.RTE]
    assert (failing.name, failing.run) == ("small", True)
    assert result.counterexample.input == {"c": -3}


@pytest.mark.skipif(not shutil.which("node"), reason="no Node.js here")
def test_what_npm_lacks_is_told_with_its_version(kata):
    adapter = "// fakelib 1.0.1: roots\n//\n// It counts.\nconst f = require('fakelib');\n"
    adapter += "function rootCount(c) {\n  return f.roots(c);\n}\n"
    (kata.solutions / "libraries" / "other.js").write_text(adapter)
    assert "fakelib is not installed: npm install fakelib@1.0.1" in run_of(kata, "other.js")


def test_no_verdict_is_wanted_of_an_adapter(kata):
    report = verify_problem(kata)
    assert not report.faults
    assert not [each for each in report.solutions if "fakelib" in each.file]


def test_a_run_without_the_package_says_what_to_install(kata, tmp_path):
    (tmp_path / "packages" / "fakelib.py").unlink()
    assert "fakelib is not installed: pip install fakelib==1.0" in run_of(kata, "fakelib.py")


@pytest.mark.parametrize("path", ADAPTERS, ids=lambda path: f"{path.parts[-3]}-{path.stem}")
def test_every_adapter_names_what_it_calls_and_has_its_row(path):
    """Ten to forty lines: its first names package, version and call, and the table has that version."""
    library, _, version = requirement(path).rpartition("==" if path.suffix == ".py" else "@")
    rows = json.loads((TESTS.parent / "problems" / path.parts[-3] / "libraries.json").read_text())
    assert (rows[path.stem]["library"], rows[path.stem]["version"]) == (library, version) != ("", "")
    assert 10 <= len(path.read_text().splitlines()) <= 40


def test_the_page_of_the_manual_has_each_row_as_it_was_measured():
    said = re.findall(r"^\| (\S+ \d\S+) \| (\d+)/(\d+) \| ([\d.]+%) \|", page("libraries").text, re.MULTILINE)
    rows = [
        (
            f"{row['library']} {row['version']}",
            *map(str, row["groups"]),
            f"{row['cases'][0] / row['cases'][1]:.1%}",
        )
        for file in TESTS.parent.glob("problems/*/libraries.json")
        for row in json.loads(file.read_text()).values()
    ]
    assert sorted(said) == sorted(rows)


@pytest.mark.nightly
@pytest.mark.parametrize(
    "path",
    [each for each in ADAPTERS if each.stem in PINNED],
    ids=lambda path: f"{path.parts[-3]}-{path.stem}",
)
def test_what_was_measured_still_holds(path):
    library, _, version = requirement(path).partition("==")
    if installed_version(library) != version:
        pytest.skip(f"{library}=={version} is not installed")
    kata = find_problem(path.parts[-3], ())
    (adapter,) = [
        each for each in read_solutions(kata, SolutionKind.LIBRARY).programs if each.path.stem == path.stem
    ]
    kept = next(each for each in library_table(kata).libraries if each.library == library)
    assert measured(adapter, fresh_data(kata), Containment()) == kept
