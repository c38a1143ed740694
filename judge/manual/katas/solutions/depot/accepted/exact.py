"""List of numbers.

A number for each shelf, and a line at a time.
"""

import sys

first, *steps = sys.stdin.read().splitlines()
boxes = [0] * (int(first.split()[0]) + 1)
for step in steps[:-1]:
    words = step.split()
    shelf = int(words[-1])
    if words[0] == "put":
        boxes[shelf] += int(words[1])
    elif words[0] == "how":
        print(boxes[shelf])
    elif boxes[shelf] < int(words[1]):
        print("refused")
    else:
        boxes[shelf] -= int(words[1])
        print(boxes[shelf])
