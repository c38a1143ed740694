"""`python -m tests.record`: compare the record with what the judge says now, or keep what it says now."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from record.compare import differences
from record.parts import PARTS, Item, kept, keys, now, write


def main() -> int:
    """Returns the exit status: 1 where something differs."""
    parser = argparse.ArgumentParser(prog="python -m tests.record", description=__doc__)
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(PARTS)}; all without one")
    parser.add_argument(
        "--only", default="", metavar="TEXT", help="only katas and transcripts with that in their name"
    )
    parser.add_argument("--write", action="store_true", help="keep what the judge says now")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), metavar="N")
    asked = parser.parse_args()
    unknown = set(asked.parts) - set(PARTS)
    if unknown:
        parser.error(f"no part is called {', '.join(sorted(unknown))}: there are {', '.join(PARTS)}")
    items = [Item(part, key) for part in asked.parts or PARTS for key in keys(part) if asked.only in key]
    found, seen = 0, sys.stderr.isatty()
    with tempfile.TemporaryDirectory(prefix="judge-tests-") as world:
        os.environ["JUDGE_CACHE"] = os.environ.get("JUDGE_CACHE") or f"{world}/cache"
        os.environ["JUDGE_LOCKS"] = f"{world}/locks"
        with ProcessPoolExecutor(asked.jobs, get_context("spawn")) as pool:
            tasks = {
                pool.submit(now, item, Path(world, f"{item.part}-{item.key.replace('/', '-')}")): item
                for item in items
            }
            for done, task in enumerate(as_completed(tasks), 1):
                item, fault = tasks[task], task.exception()
                if fault is not None:
                    found += 1
                    print(f"{item.part} {item.key}: {type(fault).__name__}: {fault}")
                    continue
                fresh = task.result()
                if seen:
                    print(f"\r{done} of {len(items)}  {item.part} {item.key}\x1b[K", end="", file=sys.stderr)
                for text in differences(kept(item), fresh):
                    found += 1
                    print(f"\r\x1b[K{text}" if seen else text)
                if asked.write:
                    write(item, fresh)
    print("\r\x1b[K" * seen + f"{found or 'no'} difference{'' if found == 1 else 's'}", file=sys.stderr)
    return 1 if found and not asked.write else 0


if __name__ == "__main__":
    sys.exit(main())
