"""Who needs nobody that is left comes next."""

from judge.problem.declare import InvalidCase, Judged, group


def solve(count, needs):
    if any(max(pair) >= count for pair in needs):
        raise InvalidCase("there is no such task")
    order, left = [], [*range(count)]
    while left:
        free = [task for task in left if not any(second == task and first in left for first, second in needs)]
        if not free:
            return None
        order.append(free[0])
        left.remove(free[0])

    def why_not(given, _group):
        if given is None:
            return "None given, but there is an order"
        if sorted(given) != [*range(count)]:
            return f"each of the {count} tasks comes once"
        for first, second in needs:
            if given.index(first) > given.index(second):
                return f"{second} needs {first}, and comes before it"
        return None

    return Judged(why_not, order)


def tasks(most, pairs, cyclic):
    """Tasks under other numbers; where it is not `cyclic`, a task needs only earlier ones."""

    def case(draw):
        count = draw.integer(2, most)
        names = [*range(count)]
        for at in range(count - 1, 0, -1):
            other = draw.integer(0, at)
            names[at], names[other] = names[other], names[at]
        needs = []
        for _ in range(draw.integer(1, pairs)):
            first, second = draw.integer(0, count - 1), draw.integer(0, count - 1)
            if first != second or cyclic:
                needs.append((names[first], names[second]) if cyclic else (names[min(first, second)], names[max(first, second)]))
        return count, tuple(needs)

    return case


GROUPS = [
    group("few", "Few tasks that need each other in one direction.", tasks(4, 4, False)),
    group("many", "Eight tasks, many needs.", tasks(8, 20, False)),
    group("circles", "Needs in a circle: there is no order.", tasks(5, 7, True)),
]
