"""Whoever hops as far as possible, each time to where the next hop ends farthest, needs the fewest."""

from judge.problem.declare import group


def solve(reach):
    hops, here, far = 0, 0, 0
    for at, each in enumerate(reach):
        if at > far:
            return None
        if at > here:
            hops, here = hops + 1, far
        far = max(far, at + each)
    return hops


def stones(low, high, least, most):
    """So many stones, each with a reach from `least` to `most`."""

    def case(draw):
        return (tuple(draw.integer(least, most) for _ in range(draw.integer(low, high))),)

    return case


def many(count):
    """Short hops, and a long one now and then, so that whoever looks at each stone it reaches is slow."""

    def case(draw):
        return (tuple(draw.integer(1, 3) if at % 40 else draw.integer(count // 4, count // 2) for at in range(count)),)

    return case


GROUPS = [
    group("few", "Few stones.", stones(1, 6, 0, 3)),
    group("no-way", "Stones from which there is no hop.", stones(4, 12, 0, 2)),
    group("one-hop", "The first hop may reach the end.", stones(2, 9, 0, 9)),
    group("n-5000", "5,000 stones: where the growth is measured from.", many(5_000), cases=4, size=5_000),
    group("n-20000", "20,000 stones.", many(20_000), cases=2, size=20_000),
    group("n-80000", "80,000 stones.", many(80_000), cases=1, size=80_000, limits={"cpu_seconds": 10}),
]
