"""Run command lines on bad problems, odd submissions and in odd worlds: does any end as none may end?

    python tests/fuzz/fuzz.py [TARGET…] [--count N] [--seed N] [--keep DIR] [--show]

A target is problems, submissions or commands; all of them where none is named. Case N of a target is made
from its seed alone, the one that is printed where something is wrong: `--seed` of it and `--count 1` make it
again, `--keep` leaves its files, `--show` prints every command line. Ends with status 1 if anything is wrong.
"""

from __future__ import annotations

import argparse
import random
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import command_lines
import problem_files
import submissions
from contract import faults
from runs import Ended, Run, Worker

TARGETS = {"problems": problem_files, "submissions": submissions, "commands": command_lines}


@dataclass(frozen=True)
class Finding:
    """A command line of a case that ended as none may end."""

    target: str
    seed: int
    story: tuple[str, ...]
    run: Run
    ended: Ended
    faults: tuple[str, ...]

    def __str__(self) -> str:
        lines = [f"{self.target} {self.seed}: {fault}" for fault in self.faults]
        lines += [f"    changed  {text}" for text in self.story]
        lines += [f"    ran      {self.run}", f"    status   {self.ended.status}"]
        lines += [f"    stderr   {line[:300]}" for line in self.ended.err.splitlines()[-4:]]
        lines += [f"    again    python tests/fuzz/fuzz.py {self.target} --seed {self.seed} --count 1 --show"]
        return "\n".join(lines).encode("utf-8", "backslashreplace").decode()


def findings(
    target: str, seeds: Sequence[int], folder: Path, worker: Worker, *, keep: bool = False, show: bool = False
) -> Iterator[Finding]:
    """What is wrong with the cases of these seeds; each has a folder of its own in `folder`."""
    module = TARGETS[target]
    for seed in seeds:
        own = folder / f"{target}-{seed}"
        place = own / "case"  # beside a folder, a command keeps what it found out about it
        for part in ("work", "home", "tmp"):
            (place / part).mkdir(parents=True)
        chance = random.Random(f"{target}:{seed}")
        story, runs = module.prepare(chance, place)
        for run in runs:
            (place / run.folder).mkdir(exist_ok=True)
            ended = worker.run(run, place)
            if show:
                text = f"{run}\n{ended.out}{ended.shown}{ended.err}-> {ended.status}\n"
                print(text.encode("utf-8", "backslashreplace").decode())
            wrong = faults(run, ended)
            if hasattr(module, "further_faults") and not wrong:
                wrong = module.further_faults(run, ended, place)
            if wrong:
                yield Finding(target, seed, tuple(story), run, ended, tuple(wrong))
        if not keep:
            for folder_of_its_own in place.glob("work/sealed"):  # which else nobody but root could empty
                folder_of_its_own.chmod(0o700)
            shutil.rmtree(own)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    names = ", ".join(TARGETS)
    parser.add_argument("targets", nargs="*", metavar="TARGET", choices=[[], *TARGETS], help=names)
    parser.add_argument("--count", type=int, default=100, metavar="N", help="cases of each target")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of the first case")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="leave the cases' files in this folder")
    parser.add_argument("--show", action="store_true", help="print every command line and what it wrote")
    options = parser.parse_args(arguments)
    total = 0
    with tempfile.TemporaryDirectory(prefix="judge-fuzz-") as temporary, Worker() as worker:
        folder = options.keep or Path(temporary)
        for target in options.targets or TARGETS:
            seeds = range(options.seed, options.seed + options.count)
            kept = options.keep is not None
            for finding in findings(target, seeds, folder, worker, keep=kept, show=options.show):
                total += 1
                print(f"{finding}\n", flush=True)
    print(f"{total} findings")
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
