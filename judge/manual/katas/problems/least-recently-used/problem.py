"""A list of pairs, the one that was used last at its end."""

from judge.problem.declare import group


class LRUCache:
    def __init__(self, capacity):
        self.capacity, self.pairs = capacity, []

    def get(self, key):
        for pair in self.pairs:
            if pair[0] == key:
                self.pairs.remove(pair)
                self.pairs.append(pair)
                return pair[1]
        return None

    def put(self, key, value):
        self.pairs = [pair for pair in self.pairs if pair[0] != key] + [(key, value)]
        self.pairs = self.pairs[-self.capacity :]


def calls(capacity, keys, longest):
    """Some calls, after which every key is asked for."""

    def case(draw):
        found = []
        for _ in range(draw.integer(1, longest)):
            key = draw.integer(0, keys)
            found.append(("get", key) if draw.integer(0, 1) else ("put", key, draw.integer(0, 99)))
        return draw.integer(1, capacity), (*found, *(("get", key) for key in range(keys + 1)))

    return case


GROUPS = [
    group("one-place", "Room for a single key.", calls(1, 2, 6)),
    group("few-keys", "More keys than places, few of each.", calls(3, 4, 12)),
    group("long", "Many calls.", calls(4, 9, 60)),
]
