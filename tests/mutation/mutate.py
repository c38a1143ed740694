"""Change a problem's accepted solutions in small ways and judge what comes out: does the data notice?

    python tests/mutation/mutate.py [PROBLEM…] [--solution NAME] [--sample N] [--seed N]

A mutant is judged as any submission is, contained and within a time limit. One that is accepted has survived:
it is right as well, such as one with another threshold that the promise allows, or the data lack a case. What
must be rejected stands in mistakes.py, where verify holds it. Ends with status 1 where most mutants survive.
"""

from __future__ import annotations

import argparse
import random
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from msgspec.structs import replace
from mutants import Mutant, mutants

from judge.data.load import ProblemData, load_data
from judge.languages import language_of
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run.execute import judge_submission
from judge.run.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = tuple(
    sorted(folder.name for folder in (ROOT / "problems").iterdir() if (folder / "problem.toml").is_file())
)
FIRST = 4  # groups that are judged first: most mutants die there
_LIMITS = {"cpu_seconds": 1.0, "wall_seconds": 5.0}  # for a group: a mutant may well be an endless loop


class Key(NamedTuple):
    """What tells one mutant from all others, whatever happens elsewhere in its file."""

    file: str  # as count/accepted/exact.py
    was: str
    becomes: str
    number: int


class Outcome(NamedTuple):
    """How one mutant fared."""

    key: Key
    verdict: Verdict

    @property
    def survived(self) -> bool:
        """Whether it was accepted."""
        return self.verdict is Verdict.AC

    def __str__(self) -> str:
        file, was, becomes, number = self.key
        return f"{file}\n    was      {was}\n    becomes  {becomes} ({number})"


def mutants_of(problem: str, solution: str | None = None) -> list[tuple[Key, Mutant]]:
    """The mutants of a problem's accepted solutions, or of one of them."""
    found = []
    for path in sorted((ROOT / "solutions" / problem / "accepted").glob(f"{solution or '*'}.py")):
        if language_of(path):  # PyPy's
            continue
        file = path.relative_to(ROOT / "solutions").as_posix()
        for mutant in mutants(path.read_text(encoding="utf-8")):
            found.append((Key(file, mutant.was, mutant.becomes, mutant.number), mutant))
    return found


def judged(data: ProblemData, source: str) -> Verdict:
    """The verdict on a mutant; most are rejected by the first groups, and then nothing more is run."""
    small = [each.group.name for each in data.groups if each.group.size is None]
    large = [each.group.name for each in data.groups if each.group.size is not None]
    verdict = Verdict.AC
    for part in (small[:FIRST], small[FIRST:], large):
        if verdict is Verdict.AC and part:
            settings = Settings(measured=False)
            judged = judge_submission(data, source.encode(), "mutant.py", settings, groups=part)
            verdict = judged.result.verdict
    return verdict


def outcomes(name: str, chosen: Sequence[tuple[Key, Mutant]], workers: int = 1) -> Iterator[Outcome]:
    """Judge mutants of one problem's solutions, in order."""
    problem = load_problem(ROOT / "problems" / name)
    short = replace(problem, limits=replace(problem.limits, **_LIMITS))
    data = ProblemData(short, load_data(problem).groups)
    with ThreadPoolExecutor(workers) as pool:
        verdicts = pool.map(lambda item: judged(data, item[1].source), chosen)
        for (key, _), verdict in zip(chosen, verdicts, strict=True):
            yield Outcome(key, verdict)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("problems", nargs="*", metavar="PROBLEM", help="all of them where none is named")
    parser.add_argument("--solution", help="only this accepted solution, without .py")
    parser.add_argument("--sample", type=int, help="only so many mutants of each problem")
    parser.add_argument("--seed", type=int, default=0, help="of the sample")
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args(arguments)
    everything: list[Outcome] = []
    for name in options.problems or PROBLEMS:
        chosen = mutants_of(name, options.solution)
        if options.sample and options.sample < len(chosen):
            chosen = random.Random(options.seed).sample(chosen, options.sample)
        for outcome in outcomes(name, chosen, options.workers):
            everything.append(outcome)
            if outcome.survived:
                print(outcome, flush=True)
    survivors = sum(outcome.survived for outcome in everything)
    print(f"{len(everything)} mutants, {survivors} survivors")
    return 1 if survivors * 2 > len(everything) else 0


if __name__ == "__main__":
    sys.exit(main())
