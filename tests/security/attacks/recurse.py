"""Recurse until the stack is gone."""

import sys

sys.setrecursionlimit(10**9)


class Loop:
    def __repr__(self):
        return repr(self)


repr(Loop())
