"""Command lines, the worlds they are run in, and how they end."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from worker import KEPT, NULL, TERMINAL

ROOT = Path(__file__).resolve().parents[2]

_MOST = 8 * 2**20  # bytes that are read of what was written


@dataclass(frozen=True)
class Run:
    """A command line and its world.

    `settings` are added to the environment; None takes a variable away. `checked` says that standard output
    is to hold JSON after `--json`.
    """

    words: tuple[str, ...]
    settings: Mapping[str, str | None] = field(default_factory=dict)
    streams: tuple[str, str, str] = (NULL, KEPT, KEPT)
    checked: bool = False
    folder: str = "work"
    gone: bool = False  # the current folder
    interrupt: float | None = None  # seconds after which it gets Ctrl-C
    typed: str = ""
    encoding: str = "utf-8"

    def __str__(self) -> str:
        world = [f"{name}={value!r}" for name, value in sorted(self.settings.items())]
        usual = zip(("stdin", "stdout", "stderr"), self.streams, (NULL, KEPT, KEPT), strict=True)
        world += [f"{name} {kind}" for name, kind, other in usual if kind != other]
        world += [f"interrupted after {self.interrupt} s"] if self.interrupt is not None else []
        world += ["in a folder that is gone"] if self.gone else []
        world += [f"encoding {self.encoding}"] if self.encoding != "utf-8" else []
        shown = shlex.join(word if len(word) < 200 else f"{word[:200]}…({len(word)})" for word in self.words)
        text = f"judge {shown}" + (f"   [{', '.join(world)}]" if world else "")
        return text.encode("utf-8", "backslashreplace").decode()


@dataclass(frozen=True)
class Ended:
    """How a command line ended: status (negative: a signal's), what it wrote, what it changed elsewhere.

    `left` are the processes that outlived it.
    """

    status: int
    out: str
    err: str
    shown: str  # on the terminal
    outside: tuple[str, ...]
    left: tuple[str, ...] = ()


class Worker:
    """The process that runs command lines; a context manager."""

    def __enter__(self) -> Worker:
        settings = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
        self._go = tempfile.TemporaryDirectory(prefix="judge-fuzz-go-")  # filling it takes half a minute
        self._process = subprocess.Popen(
            [sys.executable, "-B", str(Path(__file__).with_name("worker.py"))],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            cwd=tempfile.gettempdir(),  # as if installed: Hypothesis keeps notes on modules below it
            env={**settings, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": "0"},
        )
        return self

    def __exit__(self, *exc: object) -> None:
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
        self._go.cleanup()

    def run(self, run: Run, folder: Path) -> Ended:
        """Run it in the case's folder; it may change what is in the folder around that, and nothing else."""
        files = [folder / name for name in ("stdin", "stdout", "stderr", "terminal")]
        for file in files:
            file.write_bytes(run.typed.encode() if file is files[0] else b"")
        streams = [
            str(file) if kind == KEPT else kind for kind, file in zip(run.streams, files, strict=False)
        ]
        settings = _world(folder) | {"GOCACHE": self._go.name} | dict(run.settings)
        request = {
            "words": run.words,
            "settings": {name: value for name, value in settings.items() if value is not None},
            "streams": streams,
            "folder": str(folder / run.folder),
            "gone": run.gone,
            "interrupt": run.interrupt,
            "typed": run.typed,
            "encoding": run.encoding,
            "shown": str(files[3]),
            "roots": [str(folder.parent)],
        }
        self._process.stdin.write(json.dumps(request).encode() + b"\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        out, err, shown = (
            _text(file, run) if kind in (KEPT, TERMINAL) else ""
            for file, kind in zip(files[1:], (*run.streams[1:], TERMINAL), strict=True)
        )
        return Ended(answer["status"], out, err, shown, tuple(answer["outside"]), tuple(answer["left"]))


def _world(folder: Path) -> dict[str, str | None]:
    """The environment of a case: nothing of the person's own."""
    return {
        "PATH": os.environ["PATH"],
        "PYTHONPATH": str(ROOT),
        "HOME": str(folder / "home"),
        "TMPDIR": str(folder / "tmp"),
        "LANG": "C.UTF-8",
        "PAGER": "cat",  # any other waits for a key
        "JUDGE_DB": str(folder / "history.sqlite3"),
        "JUDGE_CACHE": str(folder / "cache"),
    }


def _text(file: Path, run: Run) -> str:
    with file.open("rb") as opened:
        return opened.read(_MOST).decode(run.encoding, "surrogateescape")
