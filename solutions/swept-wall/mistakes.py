"""How a moving disc and a wall go wrong: right ways to their first touch, and mistakes beside the lines they spoil."""

from math import hypot, sqrt
from struct import pack, unpack


def single(*numbers):
    return unpack(f"{len(numbers)}f", pack(f"{len(numbers)}f", *numbers))


def fat(P0, P1, r, A, B):
    "right"
    # + diameter-for-radius: r = r / 2
    # + diameter-for-radius: r = 2 * r
    # : The radius is doubled, as if it were half of what it is. It is the radius: use it as it is.
    # + swapped-coordinates: P0, P1 = (P0[1], P0[0]), (P1[1], P1[0])
    # : The disc's places are taken as (y, x). Their x belongs to the x of the wall.
    # + swapped-coordinates: P1 = P1[1], P1[0]
    # : P1 is taken as (y, x). Its x belongs to the x of the others.
    # + single-precision: P0, P1, A, B, (r,) = single(*P0), single(*P1), single(*A), single(*B), single(r)
    # + centre-only: return time_of_centre(P0, P1, A, B)
    # @ is r or less
    dx, dy = P1[0] - P0[0], P1[1] - P0[1]
    # ? end-for-way: dx, dy = P1
    wx, wy = B[0] - A[0], B[1] - A[1]
    # ? end-for-way: wx, wy = B
    # : B is taken for the way from A to B.
    fx, fy = P0[0] - A[0], P0[1] - A[1]
    # ? from-world-origin@all: fx, fy = P0
    gx, gy = P0[0] - B[0], P0[1] - B[1]
    # ? from-world-origin@all: gx, gy = P0
    size = max(r, *map(abs, (fx, fy, gx, gy, fx + dx, fy + dy, gx + dx, gy + dy)))
    # = size = max(r, hypot(fx, fy), hypot(gx, gy), hypot(dx, dy))
    # ? coordinate-epsilon: size = max(r, *map(abs, (*P0, *P1, *A, *B)))
    # ? coordinate-epsilon: size = max(1, r, *map(abs, (fx, fy, gx, gy, dx, dy)))
    # : The threshold does not shrink with the figure: a small disc is all epsilon. Measure the size from
    # : the disc to the wall, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-15..1e-9/6}
    # ? equality: near = 0
    # ? loose-epsilon: near = {1e-4..1e-3/1} * size
    wall = hypot(wx, wy)
    if wall == 0:
        height = foot = 0.0
        # ? no-degenerate: return None
        # @ With A == B
    else:
        height, foot = (wx * fy - wy * fx) / wall, (fx * wx + fy * wy) / wall
    # ? no-degenerate: height, foot = (wx * fy - wy * fx) / wall, (fx * wx + fy * wy) / wall
    # : A post has no length, and the division by it fails.
    start = abs(height) if 0 < foot < wall else min(hypot(fx, fy), hypot(gx, gy))
    # ? line-for-wall@start: start = abs(height) if wall else hypot(fx, fy)
    if start <= r + near:
        return 0.0
        # ? overlap-is-none: return None
    # ? loose-start: if start <= r + {1e-6..1e-3/3} * size: return 0.0
    # ? overlap-is-none: if start < r - near: return None
    # @ If they touch or overlap at the start
    # : What overlaps at the start gets None, and only what just touches gets 0. The answer is 0 for both.
    # ? tunnelling: foot = ((fx + dx) * wx + (fy + dy) * wy) / wall if wall else 0.0
    # | x, y = fx + dx, fy + dy
    # | last = abs(wx * y - wy * x) / wall if 0 < foot < wall else min(hypot(x, y), hypot(gx + dx, gy + dy))
    # | return 0.0 if start <= r + near else 1.0 if last <= r + near else None
    # ? tunnelling-sampled: for i in range(101):
    # |     x, y = fx + i / 100 * dx, fy + i / 100 * dy
    # |     foot = max(0, min(1, (x * wx + y * wy) / wall / wall)) if wall else 0
    # |     if hypot(x - foot * wx, y - foot * wy) <= r + near: return i / 100
    # | return None
    way = hypot(dx, dy)
    if way == 0:
        return None
        # ? no-motion: return 0.0
        # @ The disc may rest
        # : A disc that rests beside the wall gets 0, as if it touched it.
    # ? no-motion: pass
    times = []
    ends = ((A, fx, fy), (B, gx, gy))
    # ? one-end-only: ends = ((A, fx, fy),)
    # ? one-end-only: ends = ((B, gx, gy),)
    # : Only the end B is looked at.
    for end, x, y in ends:
        d = abs(dx * y - dy * x) / way
        # ? global-frame: d = abs((dx / way * P0[1] - dy / way * P0[0]) - (dx / way * end[1] - dy / way * end[0]))
        foot_at = -(dx * x + dy * y) / way
        # ? foot-behind: foot_at = (dx * x + dy * y) / way
        if d < r - near:
            half = sqrt((r - d) * (r + d))
            # = half = sqrt(r * r - d * d)
            times.append((foot_at - half) / way)
            # ? exit-for-entry: times.append((foot_at + half) / way)
            # : Of an end's two moments the later one is taken, at which the disc leaves it.
        elif d <= r + near:
            times.append(foot_at / way)
            # ? graze-missed: pass
            # @ only grazes an end
    # ? no-round-ends: pass
    # @ The wall has ends
    # ? square-ends@box: pass
    turn = wx * dy - wy * dx
    # ? flat-is-along: turn = wx * dy - wy * dx if abs(wx * dy - wy * dx) > 1e-2 * way * wall else 0
    if turn and wall:
        side = r if height > 0 else -r
        # ? other-side: side = -r if height > 0 else r
        # ? other-side: side = r
        # : Only one of the sides is looked at. The one that counts is that on which P0 is.
        t = (side - height) * wall / turn
        place = foot + t * (dx * wx + dy * wy) / wall
        if 0 <= place <= wall:
            times.append(t)
            # ? line-for-wall: pass
        # ? line-for-wall@start: times.append(t)
        # ? square-ends@box: if -r <= place <= wall + r: times.append(t)
        # : The wall is made longer by r on both sides, and a disc beside an end hits a corner that is not there.
        # : Fatten it evenly: the ends are circles.
    t = min(times, default=None)
    # ? slide-late: t = max(times, default=None)
    # @ from the first end on
    if t is None:
        return None
        # ? miss-is-one: return 1.0
    if t < 0:
        return None
        # ? behind-counts: return 0.0
        # : A touch before the start is moved to t = 0. It does not count: the answer is None.
    # ? behind-counts: t = abs(t)
    # @ What was before
    if (t - 1) * way > near:
        return None
        # ? t-beyond-one: return 1.0
        # : A touch after the end counts, at its own time or at t = 1. The answer is None.
    # ? tight-end: if t > 1: return None
    # ? tight-end: if t >= 1: return None
    # : A touch at the very end is left out. The end, t = 1, is in time.
    # ? loose-end: if (t - 1) * way > 1e-4 * size: return None
    return t
    # ? distance-for-parameter: return t * way
    # ? point-for-parameter: return (P0[0] + t * dx, P0[1] + t * dy)


def time_of_centre(P0, P1, A, B):
    dx, dy, wx, wy = P1[0] - P0[0], P1[1] - P0[1], B[0] - A[0], B[1] - A[1]
    turn = wx * dy - wy * dx
    if turn == 0:
        return None
    fx, fy = P0[0] - A[0], P0[1] - A[1]
    t, s = (wy * fx - wx * fy) / turn, (dy * fx - dx * fy) / turn
    return t if 0 <= t <= 1 and 0 <= s <= 1 else None


def framed(P0, P1, r, A, B):
    "right"
    p, q, a, b = complex(*P0), complex(*P1), complex(*A), complex(*B)
    near = 1e-10 * max(r, abs(a - p), abs(b - p), abs(a - q), abs(b - q))
    # ? absolute-epsilon: near = {1e-15..1e-3/12}
    wall = abs(b - a)
    turn = ((b - a) / wall).conjugate() if wall else 1
    z, v = (p - a) * turn, (q - p) * turn
    if z.imag < 0:
        z, v = z.conjugate(), v.conjugate()
    if abs(z - min(max(z.real, 0), wall)) <= r + near:
        return 0.0
    if v == 0:
        return None
    if z.imag > r and v.imag < -1e-6 * abs(v):
        t = (r - z.imag) / v.imag
        # ? centre-only: t = -z.imag / v.imag
        # : The centre is followed until it is on the wall itself. The disc is there earlier, when the centre is r away.
        if 0 <= z.real + t * v.real <= wall:
            return t if (t - 1) * abs(v) <= near else None
            # ? t-beyond-one: return t
        # ? square-ends: if -r <= z.real + t * v.real <= wall + r: return t if (t - 1) * abs(v) <= near else None
        # : The wall is made longer by r on both sides, and a disc beside an end hits a corner that is not there.
        # : Fatten it evenly: the ends are circles.
        # ? line-for-wall: return t if (t - 1) * abs(v) <= near else None
    found = []
    ends = (z, z - wall)
    for end in ends:
        u = end * (v / abs(v)).conjugate()
        depth = r - abs(u.imag)
        if depth > near:
            found.append(-u.real - sqrt(depth * (r + abs(u.imag))))
        elif depth >= -near:
            found.append(-u.real)
    first = min(found, default=-1.0)
    # ? slide-late: first = max(found, default=-1.0)
    if first < 0 or first > abs(v) + near:
        return None
    # ? t-beyond-one: if first < 0: return None
    return first / abs(v)
    # ? distance-for-parameter: return first
