"""Every choice of things is tried."""

from judge.problem.declare import group


def solve(things, capacity):
    best = {0: 0}  # the most that is worth, by its weight
    for weight, worth in things:
        for carried, value in [*best.items()]:
            if carried + weight <= capacity:
                best[carried + weight] = max(best.get(carried + weight, 0), value + worth)
    return max(best.values())


def packed(heaviest, dearest, most, capacity):
    """Up to `most` things."""

    def case(draw):
        things = tuple((draw.integer(1, heaviest), draw.integer(0, dearest)) for _ in range(draw.integer(0, most)))
        return things, draw.integer(0, capacity)

    return case


def tight(draw):
    """Some of the things fit exactly."""
    things = tuple((draw.integer(1, 20), draw.integer(1, 50)) for _ in range(draw.integer(3, 8)))
    return things, min(100, sum(weight for weight, _ in things if draw.boolean()))


def dear(draw):
    """One heavy thing, and several that are worth more by weight but leave room empty."""
    weight = draw.integer(4, 20)
    light = tuple((weight // 2 + 1, draw.integer(20, 40)) for _ in range(draw.integer(1, 3)))
    return ((weight, draw.integer(41, 60)), *light), weight + draw.integer(0, 2)


GROUPS = [
    group("few", "Few light things.", packed(5, 9, 4, 12)),
    group("tight", "Some of them fill the knapsack exactly.", tight),
    group("heavy", "Things that do not fit at all.", packed(50, 99, 8, 60)),
    group("dear", "The dearest by weight is no good choice.", dear),
    group("neighbours", "Each case differs from the one before in one argument.", packed(9, 20, 5, 25), turns=True),
]
