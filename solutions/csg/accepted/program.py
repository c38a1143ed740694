"""program

A whole program: T on the first line, then a case a line. A solid is an integer whose bits are the pieces of the ray.
"""

import sys


def answer(tokens):
    n = int(tokens[0])
    ox, oy, dx, dy = map(float, tokens[1 + 3 * n : 5 + 3 * n])
    way = complex(dx, dy)
    length = abs(way)
    turn = way.conjugate() / length
    discs = []
    size = 0.0
    for i in range(n):
        x, y, r = map(float, tokens[1 + 3 * i : 4 + 3 * i])
        size = max(size, r, abs(x - ox), abs(y - oy))
        discs.append((complex(x - ox, y - oy) * turn, r))
    eps = 1e-10 * size
    spans = []
    for centre, r in discs:
        gap = r - abs(centre.imag)
        half = (gap * (r + abs(centre.imag))) ** 0.5 if gap > eps else 0.0
        spans.append((max(0.0, centre.real - half), max(0.0, centre.real + half)) if half else (0.0, 0.0))
    cuts = [0.0]
    for end in sorted(end for span in spans for end in span):
        if end > cuts[-1] + eps:
            cuts.append(end)
    masks = []
    for span in spans:
        first, last = (sum(cut <= end for cut in cuts) - 1 for end in span)
        masks.append((1 << last) - (1 << first))
    stack = []
    for step in map(int, tokens[6 + 3 * n :]):
        if step >= 0:
            stack.append(masks[step])
        else:
            upper, lower = stack.pop(), stack.pop()
            stack.append((lower | upper, lower & upper, lower & ~upper)[-1 - step])
    inside = stack.pop()
    edges = inside ^ inside << 1  # a bit wherever the pieces before and behind differ
    changes = [at for at in range(len(cuts)) if edges >> at & 1]
    return " ".join([str(len(changes) // 2), *(repr(cuts[at] / length) for at in changes)])


def main():
    lines = sys.stdin.read().splitlines()
    print("\n".join(answer(line.split()) for line in lines[1 : 1 + int(lines[0])]))


main()
