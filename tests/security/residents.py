"""Who judges: a user with the whole judge, who may start it below any limit."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

from attackers import HERE, Attacker

ROOT = HERE.parent.parent
NEEDED = ("click", "msgspec")  # of other people, for judging with --json
SECONDS = 150
RIGHT = "def middle(a, b):\n    return (a + b) / 2\n"
WRONG = "def middle(a, b):\n    return (a + b) // 2\n"
CROWD = """
import threading, time
threading.stack_size(64 * 1024)
stay = threading.Event()
for _ in range(120):
    threading.Thread(target=stay.wait, daemon=True).start()
def middle(a, b):
    time.sleep(0.002)
    return (a + b) / 2
"""


class Judged(NamedTuple):
    """What came of one command."""

    status: int
    results: dict[str, dict[str, Any]]  # by the submission's file name
    err: str

    def verdicts(self, start: str = "") -> list[str]:
        return [found["verdict"] for name, found in self.results.items() if name.startswith(start)]

    def messages(self, start: str = "") -> set[str]:
        """What is said of each that failed."""
        found = [found["failure"] for name, found in self.results.items() if name.startswith(start)]
        return {failure["message"] for failure in found if failure}


class Resident:
    """A user, the judge as this user has it, and a pack with the problem `middle`.

    `lacking` is why this user's interpreter, which may be of another version, cannot import the packages of
    the judge's; empty where it can.
    """

    def __init__(self, attacker: Attacker) -> None:
        self.attacker = attacker
        self.home = attacker.home / "resident"
        self.cache = self.home / "cache"
        ignore = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / "judge", self.home / "judge", ignore=ignore)
        shutil.copytree(ROOT / "tests" / "fixtures" / "pack", self.home / "pack", ignore=ignore)
        if attacker.python != sys.executable:
            for name in NEEDED:
                found = importlib.util.find_spec(name)
                assert found is not None
                assert found.origin is not None
                shutil.copytree(Path(found.origin).parent, self.home / name, ignore=ignore)
        self.cache.mkdir()
        self.cache.chmod(0o777)
        self.lacking = self.run(["-c", f"import {', '.join(NEEDED)}"]).stderr.strip().rpartition("\n")[2]
        if not self.lacking:
            (right,) = self.submissions(self.home / "first", right=RIGHT)
            assert self.judge(right).verdicts() == ["AC"]  # the problem's data are built from here on

    def submissions(self, folder: Path, **sources: str) -> list[str]:
        """Files of these names and contents that this user may read."""
        folder.mkdir(parents=True, exist_ok=True)
        for above in (folder, *folder.parents[: len(folder.relative_to(self.attacker.home).parts) - 1]):
            above.chmod(0o755)
        for name, source in sources.items():
            (folder / f"{name}.py").write_text(source)
        return [str(folder / f"{name}.py") for name in sources]

    def popen(
        self, words: list[str], *, before: tuple[str, ...] = (), as_root: bool = False, **settings: str
    ) -> subprocess.Popen[str]:
        """Start its interpreter, by a command `before` it, which may have to be root's."""
        uid = None if as_root else self.attacker.uid
        return subprocess.Popen(
            [*before, self.attacker.python, *words],
            cwd="/",
            env={
                "PATH": os.environ["PATH"],
                "HOME": str(self.cache),
                "JUDGE_CACHE": str(self.cache),
                "JUDGE_LOCKS": str(self.cache / "locks"),  # it waits for nobody else on this machine
                "JUDGE_PROBLEMS": str(self.home / "pack" / "problems"),
                "PYTHONPATH": str(self.home),
                "PYTHONDONTWRITEBYTECODE": "1",
                **settings,
            },
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            user=uid,
            group=uid,
            extra_groups=None if uid is None else [],
            preexec_fn=_as_in_a_terminal,
        )

    def run(
        self,
        words: list[str],
        *,
        before: tuple[str, ...] = (),
        as_root: bool = False,
        seconds: float = SECONDS,
        **settings: str,
    ) -> subprocess.CompletedProcess[str]:
        """The same, to its end."""
        process = self.popen(words, before=before, as_root=as_root, **settings)
        try:
            out, err = process.communicate(timeout=seconds)
        except BaseException:
            process.kill()
            process.communicate()
            raise
        return subprocess.CompletedProcess(process.args, process.returncode, out, err)

    def judge(self, *words: str, before: tuple[str, ...] = (), **settings: str) -> Judged:
        """`judge run middle` with these words, bare of what comes after a verdict."""
        return judged(self.run(command(*words), before=before, **settings))


_LAUNCH = """
import json, os, resource, sys
wish = json.loads(sys.argv[1])
if wish["group"]:
    with open(wish["group"] + "/cgroup.procs", "w") as joined:
        joined.write(str(os.getpid()))
for name, ends in wish["limits"].items():
    most = resource.getrlimit(getattr(resource, name))[1]
    resource.setrlimit(getattr(resource, name), [most if end is None else end for end in ends])
if wish["user"] is not None:
    os.setgroups([])
    os.setresgid(*[wish["user"]] * 3)
    os.setresuid(*[wish["user"]] * 3)
os.execv(sys.argv[2], sys.argv[2:])
"""


def limited(attacker: Attacker, group: str = "", **limits: tuple[int, int | None]) -> tuple[str, ...]:
    """What starts a command below limits as RLIMIT_NOFILE=(soft, hard), None being as hard as it is; or in a
    control group, by root, who becomes the attacker then."""
    wish = {"group": group, "limits": limits, "user": attacker.uid if group else None}
    return attacker.python, "-c", _LAUNCH, json.dumps(wish)


def command(*words: str) -> list[str]:
    """The words of a bare `judge run` on the problem `middle`."""
    return ["-m", "judge", "run", "middle", *words, "--json", "--no-shrink", "--no-name", "--no-history"]


def judged(ended: subprocess.CompletedProcess[str]) -> Judged:
    """The results that a command wrote."""
    rows = [json.loads(line) for line in ended.stdout.splitlines()]
    assert "Traceback" not in ended.stderr, ended.stderr[-2000:]
    return Judged(ended.returncode, {Path(row["submission"]).stem: row for row in rows}, ended.stderr)


def _as_in_a_terminal() -> None:
    """Have Ctrl-C: a suite that is run in the background has it switched off for all that it starts."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
