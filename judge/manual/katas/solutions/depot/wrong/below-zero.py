"""below-zero.

Nobody looks whether there are enough.
"""

import sys

first, *steps = sys.stdin.read().splitlines()
boxes = {}
for step in steps[:-1]:
    words = step.split()
    count = {"put": 1, "take": -1, "how": 0}[words[0]] * (int(words[1]) if words[0] != "how" else 0)
    boxes[words[-1]] = boxes.get(words[-1], 0) + count
    if words[0] != "put":
        print(boxes[words[-1]])
