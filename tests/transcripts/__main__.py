"""`python -m tests.transcripts`: play the transcripts and print what differs; --write keeps what is shown."""

from __future__ import annotations

import argparse
import difflib
import os
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from transcripts.play import names, path_of, played


def main() -> int:
    """Returns the exit status: 1 where a transcript differs."""
    parser = argparse.ArgumentParser(prog="python -m tests.transcripts", description=__doc__)
    parser.add_argument("--only", default="", metavar="TEXT", help="only transcripts with TEXT in their name")
    parser.add_argument("--write", action="store_true", help="write what is shown now")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), metavar="N")
    asked = parser.parse_args()
    found = 0
    with tempfile.TemporaryDirectory(prefix="judge-tests-") as world:
        os.environ["JUDGE_CACHE"] = os.environ.get("JUDGE_CACHE") or f"{world}/cache"
        os.environ["JUDGE_LOCKS"] = f"{world}/locks"
        with ProcessPoolExecutor(asked.jobs, get_context("spawn")) as pool:
            chosen = [name for name in names() if asked.only in name]
            tasks = {
                pool.submit(played, name, Path(world, name.replace("/", "-"))): path_of(name)
                for name in chosen
            }
            for task in as_completed(tasks):
                path, fresh = tasks[task], task.result()
                kept = path.read_text(encoding="utf-8")
                if fresh != kept:
                    found += 1
                    rows = kept.splitlines(), fresh.splitlines()
                    print(*difflib.unified_diff(*rows, path.name, "now", "", "", 1, ""), sep="\n")
                    if asked.write:
                        path.write_text(fresh, encoding="utf-8", newline="\n")
    print(f"{found} of {len(chosen)} transcripts differ", file=sys.stderr)
    return 1 if found and not asked.write else 0


if __name__ == "__main__":
    sys.exit(main())
