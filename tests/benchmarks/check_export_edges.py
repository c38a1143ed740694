"""Whether the validator of a package decides as the judge does, on outputs at the edge for every kata.

    python tests/benchmarks/check_export_edges.py [--lines 4000] [--seed 7] [PROBLEM…]

A line for each kata: how many lines of output were decided, how many accepted, how many whole
outputs, and how many of both were decided otherwise. Exit status 1 where any was.
"""

from __future__ import annotations

import argparse
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from export_edges import disagreements, judged, outputs, validated

from judge.data import ProblemData
from judge.data.load import load_data
from judge.packs.cases import tests_in
from judge.packs.export import brought_along
from judge.packs.schemas import NotExportable, check_forms
from judge.problem.find import find_problem, problem_folders

EACH = 16  # lines of a case


def main() -> int:
    """The exit status."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--lines", type=int, default=4000, help="for each kata")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("problems", nargs="*")
    wish = parser.parse_args()
    rng = random.Random(wish.seed)
    total = bad = accepted = 0
    for name in wish.problems or sorted(folder.name for folder in problem_folders()):
        problem = find_problem(name, ())
        try:
            check_forms(problem)
            data = load_data(problem)
            examples = ProblemData(problem, data.groups[:1])
            if brought_along(problem, tuple(tests_in(examples, []))):
                raise NotExportable("the kata's own checker decides")
            cases = max(1, round(wish.lines / EACH / len(data.groups)))
            decided, right, differ = disagreements(data, rng, cases, EACH)
        except NotExportable as why:
            print(f"{name:18} left out: {why}", flush=True)
            continue
        group = min(data.groups, key=lambda each: len(each.cases))
        whole = outputs(data, group)
        odd = [each for each in whole if judged(data, group, each) != validated(data, group, each)]
        counts = f"lines {decided:6} accepted {right:6} outputs {len(whole)}"
        print(f"{name:18} {counts} differ {len(differ) + len(odd)}")
        for place, line in differ[:3]:
            print("   ", place, repr(line)[:200])
        for each in odd[:3]:
            print("   ", repr(each)[-100:])
        sys.stdout.flush()
        total, accepted, bad = total + decided, accepted + right, bad + len(differ) + len(odd)
    print(f"all                lines {total} accepted {accepted} differ {bad}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
