"""from every stone

For each stone it looks at all stones that a hop from it reaches.
"""


def hops(reach):
    size = len(reach)
    fewest = [None] * (size - 1) + [0]
    for at in range(size - 2, -1, -1):
        for other in range(at + 1, min(size, at + reach[at] + 1)):
            if fewest[other] is not None and (fewest[at] is None or fewest[other] + 1 < fewest[at]):
                fewest[at] = fewest[other] + 1
    return fewest[0]
