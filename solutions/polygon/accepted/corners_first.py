"""corners first

A corner is on the circle or it is not, whatever its edges do: its own distance from C says so, and it is a crossing
itself. What an edge has beside that lies clear of both its corners, so nothing can be found twice.
"""


def boundary_hits(cx, cy, r, V):
    centre = complex(cx, cy)
    seen = [complex(x - cx, y - cy) for x, y in V]
    near = 1e-10 * max(r, *(max(abs(p.real), abs(p.imag)) for p in seen))
    found = []
    for i, start in enumerate(seen):
        if abs(abs(start) - r) <= near:
            found.append((i, V[i]))
        way = seen[i - len(V) + 1] - start
        length = abs(way)
        unit = way / length
        turned = -start * unit.conjugate()  # C as the edge sees it
        d, foot = abs(turned.imag), turned.real
        if d > r + near:
            continue
        half = ((r - d) * (r + d)) ** 0.5 if d < r - near else 0
        for step in sorted({foot - half, foot + half}):
            if near < step < length - near:
                point = centre + start + step * unit
                found.append((i, (point.real, point.imag)))
    return found
