"""writing-is-no-use

A key that is stored again keeps its old place. Take it out first.
"""


class LRUCache:
    def __init__(self, capacity):
        self.capacity = capacity
        self.values = {}

    def get(self, key):
        if key not in self.values:
            return None
        value = self.values.pop(key)
        self.values[key] = value
        return value

    def put(self, key, value):
        self.values[key] = value
        if len(self.values) > self.capacity:
            del self.values[next(iter(self.values))]
