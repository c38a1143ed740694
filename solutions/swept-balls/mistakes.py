"""How two moving discs go wrong: right ways to their first touch, and mistakes beside the lines they spoil."""

from math import hypot, sqrt
from struct import pack, unpack


def single(*numbers):
    return unpack(f"{len(numbers)}f", pack(f"{len(numbers)}f", *numbers))


def relative(P0, P1, r, Q0, Q1, s):
    "right"
    # + diameter-for-radius: r, s = r / 2, s / 2
    # + diameter-for-radius: r, s = 2 * r, 2 * s
    # : The radii are doubled, as if they were given halved. They are the radii: use them as they are.
    # + swapped-coordinates: P0 = P0[1], P0[0]
    # : P0 is taken as (y, x). Its x belongs to the x of the others.
    # + swapped-coordinates: Q0, Q1 = (Q0[1], Q0[0]), (Q1[1], Q1[0])
    # : The second disc's places are taken as (y, x). Their x belongs to the x of the first disc's.
    # + single-precision: P0, P1, Q0, Q1, (r, s) = single(*P0), single(*P1), single(*Q0), single(*Q1), single(r, s)
    # + zero-radius: if r == 0 or s == 0: return None
    # @ A radius may be 0
    reach = r + s
    # ? one-radius: reach = r
    # @ is r + s or less
    # ? one-radius: reach = max(r, s)
    # : The larger radius stands for both. The discs touch where the centres are r + s apart.
    # ? radii-subtracted: reach = abs(r - s)
    fx, fy = P0[0] - Q0[0], P0[1] - Q0[1]
    # = fx, fy = -(Q0[0] - P0[0]), -(Q0[1] - P0[1])
    # ? from-world-origin: fx, fy = P0
    vx, vy = P1[0] - P0[0], P1[1] - P0[1]
    # ? end-for-way: vx, vy = P1
    wx, wy = Q1[0] - Q0[0], Q1[1] - Q0[1]
    # ? end-for-way: wx, wy = Q1
    # ? one-still@unseen: wx, wy = 0, 0
    dx, dy = vx - wx, vy - wy
    # ? one-still: dx, dy = -wx, -wy
    # : The first disc is taken to rest in P0. Both move: seen from the second, the first goes the difference of both
    # : ways.
    # ? absolute-motion: dx, dy = vx + wx, vy + wy
    # : Both ways are added, which is right only if the second one is reversed. Subtract it.
    size = max(reach, abs(vx), abs(vy), abs(fx), abs(fy), abs(Q1[0] - P0[0]), abs(Q1[1] - P0[1]))
    # = size = max(reach, hypot(vx, vy), hypot(fx, fy), hypot(wx, wy))
    # ? coordinate-epsilon: size = max(reach, *map(abs, (*P0, *P1, *Q0, *Q1)))
    # ? coordinate-epsilon: size = max(1, reach, abs(vx), abs(vy), abs(fx), abs(fy))
    # : The threshold does not shrink with the figure: small discs are all epsilon. Measure the size by the
    # : radii and the ways, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-9..1e-6/3}
    # ? equality: near = 0
    # ? loose-epsilon: near = 1e-4 * size
    # ? loose-epsilon: near = 1e-8 + 1e-5 * reach
    # : For example, the lengths are compared as np.isclose does, within 1e-5 of the radii. Choose a
    # : threshold that is between rounding and what the statement promises: 1e-9 of the size.
    away = hypot(fx, fy)
    # = away = sqrt(fx * fx + fy * fy)
    # ? global-frame: away = sqrt(abs(P0[0] * P0[0] + P0[1] * P0[1] - 2 * (P0[0] * Q0[0] + P0[1] * Q0[1]) + Q0[0] * Q0[0] + Q0[1] * Q0[1]))
    if away <= reach + near:
        return 0.0
    # ? loose-start: if away <= reach + 1e-4 * size: return 0.0
    # ? overlap-is-none: if away < reach - near: return None
    # @ If they touch or overlap at the start
    # : Discs that overlap from the start do not get 0. They touch already: the answer is 0.
    # ? exit-for-entry@inside: pass
    # : Discs that overlap from the start are asked for their next touch, when they part. They touch from t = 0 on.
    # ? tunnelling: return 1.0 if hypot(fx + dx, fy + dy) <= reach + near else None
    # : Only the start and the end are looked at. Fast discs pass through each other in between.
    # ? tunnelling-sampled: for i in range(101):
    # |     if hypot(fx + i / 100 * dx, fy + i / 100 * dy) <= reach + near: return i / 100
    # | return None
    length = hypot(dx, dy)
    if length == 0:
        return None
        # ? no-degenerate: return 0.0
        # @ A disc may rest
    # ? no-degenerate: if (vx, vy) == (0, 0): return None
    # : Only a first disc that rests is thought of. If both move alike the division fails as well; and a disc that rests
    # : may be met by the other.
    k = dx * fy - dy * fx
    d = abs(k) / length
    # = d = abs(k / length)
    # ? global-frame: d = abs((dx / length * P0[1] - dy / length * P0[0]) - (dx / length * Q0[1] - dy / length * Q0[0]))
    gap = d - reach
    # ? area-units: gap = d * d - reach * reach
    if gap > near:
        return None
        # ? miss-is-one: return 1.0
    # ? sqrt-of-negative: pass
    foot = -(dx * fx + dy * fy) / length
    # ? foot-behind: foot = (dx * fx + dy * fy) / length
    if gap >= -near:
        first = foot
        # ? graze-missed: return None
        # @ Discs that only graze
    else:
        half = sqrt((reach - d) * (reach + d))
        # = half = sqrt(reach * reach - d * d)
        # ? foot-for-entry: half = 0
        first = foot - half
        # = first = (away - reach) * (away + reach) / (foot + half) if foot > 0 else foot - half
        # ? exit-for-entry@inside: first = foot - half if foot - half >= 0 else foot + half
    if first < 0:
        return None
        # ? behind-counts: return 0.0
        # : A touch before the start is moved to t = 0. It does not count: the answer is None.
    # ? behind-counts: first = abs(first)
    # @ What was before
    if first > length + near:
        return None
        # ? t-beyond-one: return 1.0
        # : A touch after the end is moved to t = 1. It does not count: the answer is None.
    # ? tight-end: if first >= length: return None
    # : A touch at the very end is left out. The end, t = 1, is in time.
    # ? loose-end: if first > length + 1e-4 * size: return None
    # ? loose-end: if first > 1.000001 * length: return None
    # : The end has a slack in t, 1e-6: on a long way that is more than 1e-7 of the size. Take 1e-9 of the size.
    return first / length
    # ? distance-for-parameter: return first
    # ? distance-for-parameter: return first / hypot(vx, vy)
    # : The way to the touch as seen from the second disc is divided by the first one's own way. Divide by the length of
    # : the motion that it was measured on.
    # ? point-for-parameter: return (P0[0] + first / length * vx, P0[1] + first / length * vy)


def quadratic(P0, P1, r, Q0, Q1, s):
    "right"
    fx, fy = P0[0] - Q0[0], P0[1] - Q0[1]
    dx, dy = P1[0] - P0[0] - Q1[0] + Q0[0], P1[1] - P0[1] - Q1[1] + Q0[1]
    reach = r + s
    size = max(reach, *map(abs, (fx, fy, P1[0] - P0[0], P1[1] - P0[1], Q1[0] - P0[0], Q1[1] - P0[1])))
    a, b = dx * dx + dy * dy, dx * fx + dy * fy
    c = fx * fx + fy * fy - reach * reach
    touch = 1e-10 * size * (2 * reach + 1e-10 * size)
    # ? absolute-epsilon: touch = {1e-15..1e-3/12}
    # ? area-units: touch = 1e-10 * size
    # : For example, an area is compared with a length, 1e-10 of the size. Multiply the threshold by r + s.
    if c <= touch:
        return 0.0
    # ? exit-for-entry@inside: if abs(c) <= touch: return 0.0
    # : Discs that overlap from the start are asked for their next touch, when they part. They touch from t = 0 on.
    if b >= 0:
        return None
    # ? behind-counts: if a == 0: return None
    # ? exit-for-entry@inside: if a == 0: return None
    k = dx * fy - dy * fx
    disc = reach * reach * a - k * k
    if disc < -touch * a:
        return None
    # ? sqrt-of-negative@root: pass
    root = sqrt(disc) if disc > touch * a else 0.0
    # ? sqrt-of-negative@root: root = sqrt(disc)
    t = c / (root - b)
    # = t = (-b - root) / a
    # ? exit-for-entry: t = (-b + root) / a
    # ? exit-for-entry@inside: t = (-b - root) / a if c > 0 else (-b + root) / a
    # ? unhalved: t = (-2 * b - root) / (2 * a)
    # ? not-divided: t = -b - root
    return t if (t - 1) * sqrt(a) <= 1e-10 * size else None
    # ? t-beyond-one: return t
    # ? rounded-output: return round(t, 6) if (t - 1) * sqrt(a) <= 1e-10 * size else None
