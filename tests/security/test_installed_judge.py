"""A judge that was really installed hides its solutions, whatever symlinks lead to it.

The wheel is installed once for each attacker, below `current -> releases/7` as many servers have it.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sysconfig
import zipfile
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from attackers import HERE, LEVELS, SECONDS, USERS, Attacker, matrix
from sampling import daily, nightly

ROOT = HERE.parents[1]
DEPENDENCIES = ("click", "hypothesis", "jinja2", "mistletoe", "msgspec", "platformdirs", "rich")


class Installed(NamedTuple):
    """One installation as one user starts it."""

    attacker: Attacker
    python: Path
    path: str  # $PYTHONPATH

    def run(self, *command: str, **environment: str) -> subprocess.CompletedProcess[str]:
        home = self.attacker.home / "own"
        return subprocess.run(
            [str(self.python), *command],
            cwd="/",
            env={
                "PATH": os.environ["PATH"],
                "HOME": str(home),
                "PYTHONPATH": self.path,
                "PYTHONDONTWRITEBYTECODE": "1",
                "JUDGE_DB": str(home / "history.sqlite3"),
                "JUDGE_CACHE": str(home / "cache"),
                "JUDGE_LOCKS": str(home / "locks"),
                **environment,
            },
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
            user=self.attacker.uid,
            group=self.attacker.uid,
            extra_groups=None if self.attacker.uid is None else [],
        )

    def look(self, level: str, *forgotten: str) -> dict[str, Any]:
        """What a submission finds at a level."""
        ended = self.run(str(self.attacker.home / "security" / "installed.py"), level, *forgotten)
        assert ended.returncode == 0, ended.stderr
        return json.loads(ended.stdout)  # type: ignore[no-any-return]


def _make(folder: Path, python: str) -> Path:
    """A virtual environment's own place for modules, which takes the judge's dependencies from ours."""
    subprocess.run([python, "-m", "venv", "--without-pip", str(folder)], check=True, umask=0o022, timeout=60)
    (site,) = folder.glob("lib/python3*/site-packages")
    (site / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    if not (folder / "lib64").exists():
        (folder / "lib64").symlink_to("lib")
    return site


@pytest.fixture
def installations(attacker: Attacker, wheel: Path) -> dict[str, Installed]:
    """The layouts, by their names; made once for each user. A pure wheel is installed by unpacking it."""
    if attacker.installed:
        return attacker.installed
    app = attacker.home / "app"
    release = app / "releases" / "7"
    release.mkdir(parents=True)
    (app / "current").symlink_to("releases/7")
    (attacker.home / "own").mkdir()
    if attacker.uid is not None:
        os.chown(attacker.home / "own", attacker.uid, attacker.uid)
    site, editable = (_make(release / name, attacker.python) for name in ("venv", "editable"))
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    for name in ("judge", "problems", "solutions"):
        shutil.copytree(ROOT / name, app / "checkout" / name, ignore=shutil.ignore_patterns("__pycache__"))
    (editable / "checkout.pth").write_text(f"{app / 'checkout'}\n")
    plain, linked = (app / way / "venv" / "bin" / "python" for way in ("releases/7", "current"))
    lib64 = {
        each: str(each.parents[1] / "lib64" / site.parent.name / "site-packages") for each in (plain, linked)
    }
    attacker.installed = {
        "plain": Installed(attacker, plain, ""),
        "linked": Installed(attacker, linked, ""),
        "lib64": Installed(attacker, plain, lib64[plain]),
        "linked-lib64": Installed(attacker, linked, lib64[linked]),
        "two-names": Installed(attacker, linked, str(site)),
        "editable": Installed(attacker, app / "current/editable/bin/python", ""),
    }
    return attacker.installed


LAYOUTS = ["plain", "linked", "lib64", "linked-lib64", "two-names", "editable"]
CONTAINED = ["full", "strong"]
BY_DAY = {("linked-lib64", "full", "plain"), ("two-names", "strong", "plain")}


@pytest.mark.parametrize(("layout", "level", "user"), matrix(LAYOUTS, CONTAINED, BY_DAY))
def test_no_submission_finds_a_solution(
    attacker: Attacker, installations: dict[str, Installed], level: str, layout: str
) -> None:
    attacker.require(level)
    outcome = installations[layout].look(level)
    assert outcome == {"stop": "answered", "isolation": level, "found": [], "errors": ""}


@pytest.mark.parametrize("user", ["plain"])
@pytest.mark.parametrize("layout", daily(LAYOUTS, ["linked-lib64"]))
def test_the_same_submission_finds_it_where_nothing_is_hidden(
    installations: dict[str, Installed], layout: str
) -> None:
    outcome = installations[layout].look("limits")
    assert outcome["stop"] == "answered", outcome
    assert [path for path in outcome["found"] if path.endswith("/exact.py")], outcome


@pytest.mark.parametrize("user", ["plain"])
@pytest.mark.parametrize(
    ("layout", "forgotten", "level"),
    [
        *[("plain", "unseen", "best"), ("linked-lib64", "searched", "strong")],
        *[nightly("linked-lib64", "unseen", "full"), nightly("plain", "searched", "full")],
        *[nightly("linked-lib64", "searched", "best"), nightly("plain", "unseen", "strong")],
    ],
)
def test_where_hiding_has_failed_nothing_runs(
    attacker: Attacker, installations: dict[str, Installed], level: str, layout: str, forgotten: str
) -> None:
    """Each of the two lists that are looked at inside is enough; nor is a lower level taken instead."""
    attacker.require("strong" if level == "best" else level)
    outcome = installations[layout].look(level, "hidden", forgotten)
    assert list(outcome) == ["refused"], outcome
    assert "would let a submission read" in outcome["refused"]
    assert "/site-packages/judge" in outcome["refused"]
    assert "virtual environment of its own" in outcome["refused"]


@pytest.mark.parametrize(
    ("layout", "user", "level"),
    [
        ("plain", "plain", "full"),
        ("plain", "plain", "limits"),
        *(
            nightly(layout, user, level)
            for layout in ("linked", "lib64")
            for user in USERS
            for level in LEVELS
        ),
    ],
)
def test_who_reads_the_solution_is_accepted_without_containment_only(
    attacker: Attacker, installations: dict[str, Installed], level: str, layout: str
) -> None:
    attacker.require(level)
    there = installations[layout]
    if there.run("-c", f"import {', '.join(DEPENDENCIES)}").returncode:
        pytest.skip(f"{attacker.name} cannot import the judge's dependencies with {attacker.python}")
    submission = str(attacker.home / "security" / "submissions" / "look_for_solution.py")
    words = ["run", "count", submission, "--json", "--no-shrink", "--no-name", "--isolation", level]
    ended = there.run("-m", "judge", *words)
    result = json.loads(ended.stdout)
    assert (result["isolation"], ended.stderr) == (level, "")
    assert (ended.returncode, result["verdict"]) == ((0, "AC") if level == "limits" else (1, "WA"))
