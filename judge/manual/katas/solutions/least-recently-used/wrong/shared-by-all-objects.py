"""shared-by-all-objects

All objects have the same values, which the class holds. Make them in `__init__`.
"""


class LRUCache:
    values = {}

    def __init__(self, capacity):
        self.capacity = capacity

    def get(self, key):
        if key not in self.values:
            return None
        value = self.values.pop(key)
        self.values[key] = value
        return value

    def put(self, key, value):
        self.values.pop(key, None)
        self.values[key] = value
        if len(self.values) > self.capacity:
            del self.values[next(iter(self.values))]
