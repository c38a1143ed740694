"""some-are-taken

Who takes too many gets what is there. Leave the boxes where they are.
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
        boxes[shelf] = 0
    else:
        boxes[shelf] -= int(words[1])
        print(boxes[shelf])
