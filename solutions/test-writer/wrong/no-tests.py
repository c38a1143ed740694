"""no-tests

An empty list is returned. Nothing is tested by no cases: give one to twelve.
"""


def cases():
    return []
