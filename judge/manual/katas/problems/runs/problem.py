"""Run-length encoding: `aaab` is `3ab`."""

from itertools import groupby

from judge.problem.declare import group


def solve(s):
    lengths = ((len(list(run)), letter) for letter, run in groupby(s))
    return "".join(f"{length}{letter}" if length > 1 else letter for length, letter in lengths)


def texts(letters, least, longest):
    """Some runs, each of `least` to `longest` letters."""

    def case(draw):
        runs = [
            draw.choice(letters) * draw.integer(least, longest) for _ in range(draw.integer(0, 60 // longest))
        ]
        return ("".join(runs),)  # two runs of one letter, side by side, are one

    return case


GROUPS = [
    group("short", "Runs of one to four letters.", texts("abc", 1, 4)),
    group("alone", "No letter stands beside its like.", texts("abcdefgh", 1, 1)),
    group("long", "Runs of ten letters and more.", texts("abc", 9, 15)),
    group("blanks", "Blanks at the ends and between.", texts(" a b", 1, 3)),
]
