"""How the nearest of many goes wrong: a right tree of boxes with mistakes beside the lines, and a plain loop."""

from math import hypot, inf, sqrt


def tree(circles, rays):
    "right"
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # + diameter-for-radius: circles = [(x, y, 2 * r) for x, y, r in circles]
    # @ `circles` is a list of `(x, y, r)`
    grown = [(x - r, x + r, y - r, y + r) for x, y, r in circles]
    # ? boxes-of-centres: grown = [(x, x, y, y) for x, y, r in circles]

    def build(indices):
        (a, b, c, d) = zip(*(grown[i] for i in indices))
        if len(indices) <= 4:
            return min(a), max(b), min(c), max(d), indices, None, None
        axis, half = (0 if max(b) - min(a) >= max(d) - min(c) else 1), len(indices) // 2
        indices = sorted(indices, key=lambda i: circles[i][axis])
        return min(a), max(b), min(c), max(d), None, build(indices[:half]), build(indices[half:])

    root = build(range(len(circles)))
    x0, x1 = min(c[0] for c in circles), max(c[0] for c in circles)
    y0, y1 = min(c[1] for c in circles), max(c[1] for c in circles)
    most = max(c[2] for c in circles)
    answers = []
    # + kept-between-rays@loop: best, found, at = inf, None, 0.0
    for (ox, oy), (dx, dy) in rays:
        near = 1e-10 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        # ? target-for-direction: near, dx, dy = 1e-10 * most, dx - ox, dy - oy or 1
        # @ the ray is O + t·D
        # = near = 1e-9 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        # ? loose-epsilon: near = {1e-3..1e-2/1} * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        length = hypot(dx, dy)
        ux, uy = dx / length or 1e-300, dy / length or 1e-300

        def enters(box):
            a, b = (box[0] - near - ox) / ux, (box[1] + near - ox) / ux
            c, d = (box[2] - near - oy) / uy, (box[3] + near - oy) / uy
            start, end = max(min(a, b), min(c, d)), min(max(a, b), max(c, d))
            # ? box-inside-is-miss: return start if 0 <= start <= end else inf
            return max(0.0, start) if max(0.0, start) <= end else inf

        best, found, at = inf, None, 0.0
        # ? kept-between-rays@loop: pass
        # : The best t so far is set to infinity once, before the first ray.
        stack = [(enters(root), root)]
        while stack:
            start, box = stack.pop()
            if start == inf or start > best:
                continue
            # ? stops-at-first-hit: if start == inf or found is not None: continue
            if box[4] is None:
                one, other = (enters(box[5]), box[5]), (enters(box[6]), box[6])
                # ? nearer-box-only: other = (inf, box[6]) if one[0] <= other[0] < inf else other
                stack += (other, one) if one[0] <= other[0] else (one, other)
                continue
            for index in box[4]:
                x, y, r = circles[index]
                fx, fy = x - ox, y - oy
                # ? forgotten-start: fx, fy = x, y
                gap = abs(dx * fy - dy * fx) / length - r
                # ? not-divided: gap = abs(dx * fy - dy * fx) - r
                if gap > near:
                    continue
                middle = (dx * fx + dy * fy) / length
                # + centre-behind: if middle < -near: continue
                half = sqrt(-gap * (gap + r + r)) if gap < -near else 0.0
                # + tangent-missed: if gap >= -near: continue
                # + foot-for-root: half = 0.0
                t = middle - half
                # ? far-root: t = middle + half
                if t < -near: t = middle + half
                # ? origin-on-circle@both: if t <= near: t = middle + half
                # @ A ray that starts on a circle
                # ? inside-is-miss: pass
                # @ a ray that starts inside meets it where it leaves
                # ? entry-behind@both: if middle + half < -near: continue
                # ? disc-for-circle: if t < -near <= middle + half: t = 0.0
                # @ A circle is the curve
                # : A ray that starts inside is taken to meet the disc at once, at t = 0.
                # ? absolute-value: t = abs(t)
                # @ What lies behind the origin
                # : A circle behind the origin is met at |t|.
                if t < -near: continue
                # ? origin-on-circle@both: if t <= near: continue
                # ? entry-behind@both: pass
                # + segment-for-ray: if t > length: continue
                key = t
                # ? index-of-centre-distance: key = hypot(fx, fy)
                # @ where circle i is met first
                # ? index-of-centre-distance: key = hypot(fx, fy) - r
                # : The circle whose disc is nearest to the origin is taken, and not the one that is met first.
                if key < best: best, found, at = key, index, t
                # = if key <= best: best, found, at = key, index, t
                # ? no-shrink: best, found, at = min(best, key), index, t
                # ? no-shrink: if found is None: best, found, at = key, index, t
                # : The best t is noted once, and a nearer hit does not replace it.
                # ? index-only: if key < best: best, found, at = key, index, at or t
        answers.append(None if found is None else (found, (at if at > near else 0.0) / length))
        # ? distance-for-parameter: answers.append(None if found is None else (found, at))
        # @ t is the parameter, not a distance
        # ? rounded-parameter: answers.append(None if found is None else (found, round(at / length, 6)))
        # ? one-based: answers.append(None if found is None else (found + 1, (at if at > near else 0.0) / length))
        # @ Indices count from 0
        # ? sentinel-miss: answers.append((-1, -1.0) if found is None else (found, (at if at > near else 0.0) / length))
        # @ `None` for a ray
        # ? point-for-parameter: answers.append(None if found is None else (found, ox + at / length * dx))
        # : The x of the point is returned, where t is asked for.
    return answers
    # ? misses-left-out: return [each for each in answers if each is not None]
    # @ one element for each ray


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
