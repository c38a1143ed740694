"""Whoever hops as far as possible, each time to where the next hop ends farthest, needs the fewest."""

from judge.drawing import Role, table
from judge.problem.declare import Hooks, group


def solve(reach):
    hops, here, far = 0, 0, 0
    for at, each in enumerate(reach):
        if at > far:
            return None
        if at > here:
            hops, here = hops + 1, far
        far = max(far, at + each)
    return hops


def way(reach):
    """The stones of a shortest way to the last one."""
    stones = [len(reach) - 1]
    while stones[0]:
        stones.insert(0, next((at for at in range(stones[0]) if at + reach[at] >= stones[0]), 0))
    return stones


def picture(shown):
    reach = shown.values["reach"]
    if shown.exact is None or len(reach) > 12:
        return None
    return table([range(len(reach)), reach], {(1, at): Role.WANTED for at in way(reach)}, "stones and their reach")


HOOKS = Hooks(picture=picture)


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
