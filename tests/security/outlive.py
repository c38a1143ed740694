"""`outlive.py daemon LEVEL` runs the daemon and watches its traces; any other name is run until somebody
kills us, with a number after the level in as many boxes at once, each in its thread.
"""

from __future__ import annotations

import json
import sys
import tempfile
import threading
import time
from pathlib import Path

from table import SCRIPTS

from judge.sandbox import open_box
from judge.sandbox.boundary import Limits

PATIENT = Limits(cpu_seconds=30.0, wall_seconds=30.0, memory_bytes=256 << 20, output_bytes=1 << 20)
CLOSE_AND_SLEEP = "import os, time\nos.closerange(0, 1024)\nwhile True:\n    time.sleep(1)\n"


def watch_daemon(level: str) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o777)
        with open_box(SCRIPTS["daemon"].encode(), "daemon.py", level=level) as box:
            result = box.run_program(json.dumps({"folder": name}).encode(), PATIENT)
            at_end = _size(folder / "heartbeat")
        time.sleep(0.3)
        later = _size(folder / "heartbeat")
    print(json.dumps({"output": result.stdout.decode(), "at_end": at_end, "later": later}))


def _size(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


def run_until_killed(what: str, level: str, count: int) -> None:
    source = SCRIPTS.get(what, CLOSE_AND_SLEEP).encode()
    ready = threading.Barrier(count)

    def run() -> None:
        with open_box(source, "hostile.py", level=level) as box:
            box.inspect()
            if ready.wait() == 0:
                print("started", flush=True)
            box.run_program(b"", PATIENT)

    for _ in range(count - 1):
        threading.Thread(target=run, daemon=True).start()
    run()


if __name__ == "__main__":
    if sys.argv[1] == "daemon":
        watch_daemon(sys.argv[2])
    else:
        run_until_killed(sys.argv[1], sys.argv[2], int([*sys.argv, "1"][3]))
