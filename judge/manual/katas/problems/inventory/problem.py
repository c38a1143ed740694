"""Counts in a dict: one that comes to 0 leaves it."""

from judge.problem.declare import group

THINGS = ("bolt", "cog", "gear", "nut", "pin", "rod")


def solve(stock, moves):
    left = dict(stock)
    for thing, count in moves:
        total = left.get(thing, 0) + count
        if total >= 0:
            left[thing] = total
    return {thing: count for thing, count in left.items() if count}


def moves(things, most, low, high, longest=20):
    """Up to `longest` moves of `low` to `high` of some things, most of which are there, up to `most` of each."""

    def case(draw):
        stock = {thing: draw.integer(1, most) for thing in THINGS[:things] if draw.integer(0, 3)}
        return stock, tuple((draw.choice(THINGS[:things]), draw.integer(low, high)) for _ in range(draw.integer(0, longest)))

    return case


GROUPS = [
    group("in", "Things come, new ones among them.", moves(4, 9, 1, 9)),
    group("out", "Things come and go, a few at a time.", moves(6, 9, -4, 3)),
    group("all", "Often the last one goes.", moves(2, 2, -2, 1, 3)),
    group("many", "Large counts of either sign.", moves(5, 99, -99, 99)),
]
