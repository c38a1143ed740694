"""How the nearest of many goes wrong: a right grid with mistakes beside the lines, and a plain loop."""

from math import hypot, inf, sqrt


def grid(circles, rays):
    "right"
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # + diameter-for-radius: circles = [(x, y, 2 * r) for x, y, r in circles]
    left, low = min(x - r for x, y, r in circles), min(y - r for x, y, r in circles)
    wide = max(x + r for x, y, r in circles) - left
    tall = max(y + r for x, y, r in circles) - low
    side = max(1.5 * sqrt(wide * tall / len(circles)), max(wide, tall) / 1000)
    columns, rows = int(wide / side) + 1, int(tall / side) + 1
    cells = {}
    for index, (x, y, r) in enumerate(circles):
        reach = r
        # ? centre-cell-only: reach = min(r, side)
        # : A circle is looked for in the cells around its centre alone, and a large one reaches further.
        # ? centre-cell-only: reach = 0
        # : A circle is entered in the cell of its centre alone.
        for column in range(int((x - reach - left) / side), int((x + reach - left) / side) + 1):
            for row in range(int((y - reach - low) / side), int((y + reach - low) / side) + 1):
                cells.setdefault((column, row), []).append(index)
    x0, x1 = min(c[0] for c in circles), max(c[0] for c in circles)
    y0, y1 = min(c[1] for c in circles), max(c[1] for c in circles)
    most = max(c[2] for c in circles)
    answers = []
    # + kept-between-rays@loop: best, found, at = inf, None, 0.0
    for (ox, oy), (dx, dy) in rays:
        # + target-for-direction: dx, dy = (dx - ox, dy - oy) if (dx, dy) != (ox, oy) else (1, 0)
        near = 1e-10 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        # ? loose-epsilon: near = {1e-5..1e-2} * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        length = hypot(dx, dy)
        start, end = 0.0, inf
        for o, d, least, size in ((ox, dx, left, columns * side), (oy, dy, low, rows * side)):
            if d:
                a, b = (least - o) / d, (least + size - o) / d
                start, end = max(start, min(a, b)), min(end, max(a, b))
            elif not least <= o <= least + size:
                end = -inf
        column = min(columns - 1, max(0, int((ox + start * dx - left) // side)))
        row = min(rows - 1, max(0, int((oy + start * dy - low) // side)))
        to_column = (left + (column + (dx > 0)) * side - ox) / dx if dx else inf
        to_row = (low + (row + (dy > 0)) * side - oy) / dy if dy else inf
        best, found, at = inf, None, 0.0
        # ? kept-between-rays@loop: pass
        # : The best t so far is set to infinity once, before the first ray.
        while start <= end and 0 <= column < columns and 0 <= row < rows:
            for index in cells.get((column, row), ()):
                x, y, r = circles[index]
                fx, fy = x - ox, y - oy
                # ? forgotten-start: fx, fy = x, y
                gap = abs(dx * fy - dy * fx) / length - r
                # ? not-divided: gap = abs(dx * fy - dy * fx) - r
                if gap > near:
                    continue
                middle = (dx * fx + dy * fy) / length
                half = sqrt(-gap * (gap + r + r)) if gap < -near else 0.0
                # + tangent-missed: if gap >= -near: continue
                # + foot-for-root: half = 0.0
                t = middle - half
                # ? far-root: t = middle + half
                if t < -near: t = middle + half
                # ? origin-on-circle@both: if t <= near: t = middle + half
                # ? inside-is-miss: pass
                # ? entry-behind@both: if middle + half < -near: continue
                # ? disc-for-circle: if t < -near <= middle + half: t = 0.0
                # : A ray that starts inside is taken to meet the disc at once, at t = 0.
                # ? absolute-value: t = abs(t)
                # : A circle behind the origin is met at |t|.
                if t < -near: continue
                # ? origin-on-circle@both: if t <= near: continue
                # ? entry-behind@both: pass
                # + segment-for-ray: if t > length: continue
                key = t
                # ? index-of-centre-distance: key = hypot(fx, fy)
                # ? index-of-centre-distance: key = hypot(fx, fy) - r
                # : The circle whose disc is nearest to the origin is taken, and not the one that is met first.
                if key < best: best, found, at = key, index, t
                # = if key <= best: best, found, at = key, index, t
                # ? no-shrink: best, found, at = min(best, key), index, t
                # ? no-shrink: if found is None: best, found, at = key, index, t
                # : The best t is noted once, and a nearer hit does not replace it.
                # ? index-only: if key < best: best, found, at = key, index, at or t
            border = min(to_column, to_row)
            if best < border * length - 2 * near: break
            # ? stops-at-first-cell-hit: if found is not None: break
            # ? cell-of-origin-only: break
            if to_column < to_row:
                column, to_column = column + (1 if dx > 0 else -1), to_column + side / abs(dx)
            else:
                row, to_row = row + (1 if dy > 0 else -1), to_row + side / abs(dy)
        answers.append(None if found is None else (found, (at if at > near else 0.0) / length))
        # ? distance-for-parameter: answers.append(None if found is None else (found, at))
        # ? rounded-parameter: answers.append(None if found is None else (found, round(at / length, 6)))
        # ? one-based: answers.append(None if found is None else (found + 1, (at if at > near else 0.0) / length))
        # ? sentinel-miss: answers.append((-1, -1.0) if found is None else (found, (at if at > near else 0.0) / length))
        # ? point-for-parameter: answers.append(None if found is None else (found, ox + at / length * dx))
        # : The x of the point is returned, where t is asked for.
    return answers
    # ? misses-left-out: return [each for each in answers if each is not None]


def loop(circles, rays):
    "first-index"
    answers = []
    for (ox, oy), (dx, dy) in rays:
        near = 1e-10 * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
        length, found = hypot(dx, dy), None
        for index, (x, y, r) in enumerate(circles):
            gap = abs(dx * (y - oy) - dy * (x - ox)) / length - r
            middle = (dx * (x - ox) + dy * (y - oy)) / length
            half = sqrt(-gap * (gap + r + r)) if gap < -near else 0.0
            if gap <= near and middle + half >= -near:
                t = middle - half if middle - half >= -near else middle + half
                found = index, (t if t > near else 0.0) / length
                break
        answers.append(found)
    return answers
