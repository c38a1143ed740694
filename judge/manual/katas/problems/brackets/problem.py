"""Brackets that open and close."""

from judge.problem.declare import group

PAIRS = "()", "[]", "{}"


def solve(s):
    while any(pair in s for pair in PAIRS):  # an innermost pair goes, until there is none
        for pair in PAIRS:
            s = s.replace(pair, "")
    return not s


def closed(draw):
    """Pairs, each put anywhere into those before it."""
    s = ""
    for _ in range(draw.integer(0, 8)):
        at = draw.integer(0, len(s))
        s = s[:at] + draw.choice(PAIRS) + s[at:]
    return s


def changed(draw):
    """Some brackets become others, most often one or two."""
    s = closed(draw) + draw.choice(PAIRS)
    for _ in range(draw.integer(1, 3)):
        at = draw.integer(0, len(s) - 1)
        s = s[:at] + draw.choice("()[]{}") + s[at + 1 :]
    return (s,)


GROUPS = [
    group("balanced", "All is closed in the right order.", lambda draw: (closed(draw),)),
    group("changed", "Some brackets are others.", changed),
    group("cut", "The beginning or the end is missing.", lambda draw: (closed(draw)[draw.integer(0, 3) : draw.integer(4, 16)],)),
    group("turned", "A balanced text from right to left.", lambda draw: (closed(draw)[::-1],)),
]
