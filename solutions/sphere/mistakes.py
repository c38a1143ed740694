"""How the first point on a sphere and its normal go wrong: right ways, and mistakes beside the lines they spoil."""

from math import hypot, sqrt


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def foot(C, r, O, D):
    "right"
    # + swapped-coordinates: C = (C[1], C[0], C[2])
    # + planar: O, D = (O[0], O[1], C[2]), (D[0], D[1], 0)
    # + planar: O, D = (C[0], O[1], O[2]), (0, D[1], D[2])
    # : x is left out, of the ray and of the centre. All three axes count.
    if r == 0:
        return None
        # ? zero-radius: return 0.0, (0.0, 0.0, 0.0)
        # @ and r = 0
    # ? zero-radius: pass
    # : r = 0 goes the general way, and the normal is divided by it. There is no sphere then: return None first.
    fx, fy, fz = O[0] - C[0], O[1] - C[1], O[2] - C[2]
    # ? forgotten-centre: fx, fy, fz = O
    # ? reversed-vector: fx, fy, fz = C[0] - O[0], C[1] - O[1], C[2] - O[2]
    # ? two-components: fx, fy, fz = O[0] - C[0], O[1] - C[1], 0
    # : f = O − C has its x and y only. It has three parts.
    dx, dy, dz = D
    size = max(r, abs(fx), abs(fy), abs(fz))
    # = size = max(r, hypot(fx, fy, fz))
    # ? coordinate-epsilon: size = max(r, *map(abs, (*C, *O)))
    # ? coordinate-epsilon: size = max(1, r, abs(fx), abs(fy), abs(fz))
    # : The threshold does not shrink with the figure: a small sphere is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = 1e-9
    # ? loose-epsilon: near = {1e-4..1e-2/2} * size
    slack = near
    # ? no-snap: slack = 0
    # ? loose-origin: slack = {1e-4..1e-2/2} * size
    length = hypot(dx, dy, dz)
    # = length = sqrt(dx * dx + dy * dy + dz * dz)
    # ? two-components: length = hypot(dx, dy)
    # : |D| is that of its x and y. All three parts belong to it.
    if length == 0:
        return None
        # ? no-degenerate: return (0.0, (0.0, 0.0, 0.0)) if abs(hypot(fx, fy, fz) - r) <= near else None
    # ? no-degenerate: pass
    # : The direction is divided by its length without asking whether it has one: for D = 0 that is a division
    # : by zero. Return None before anything else.
    ux, uy, uz = dx / length, dy / length, dz / length
    # ? direction-not-normalised: ux, uy, uz = dx, dy, dz
    kx, ky, kz = uy * fz - uz * fy, uz * fx - ux * fz, ux * fy - uy * fx
    # ? swapped-coordinates: kx, ky, kz = uy * fz + uz * fy, uz * fx + ux * fz, ux * fy + uy * fx
    # : The parts of the cross product are sums. Each is a difference: uy·fz − uz·fy, and so on.
    # ? global-frame: kx, ky, kz = (uy * O[2] - uz * O[1]) - (uy * C[2] - uz * C[1]), (uz * O[0] - ux * O[2]) - (uz * C[0] - ux * C[2]), (ux * O[1] - uy * O[0]) - (ux * C[1] - uy * C[0])
    d = hypot(kx, ky, kz)
    # = d = sqrt(kx * kx + ky * ky + kz * kz)
    # ? scalar-cross: d = abs(kz)
    # ? scalar-cross: d = abs(kx + ky + kz)
    # : The three parts of the cross product are added up. It is a vector: take the root of their squares' sum.
    # = d = sqrt(max(0.0, fx * fx + fy * fy + fz * fz - (ux * fx + uy * fy + uz * fz) ** 2))
    gap = r - d
    where = 1 if gap < -near else 0 if gap <= near else -1
    # ? equality: where = 1 if gap < 0 else 0 if gap == 0 else -1
    # ? absolute-epsilon: where = 1 if gap < 0 else 0 if r * r - d * d <= 1e-9 else -1
    # : For example, what stands under the root is compared with a fixed number, whatever the size of the
    # : figure. Compare lengths, within a small part of the size.
    # ? tangent-missed: where = 1 if gap <= near else -1
    # ? sqrt-of-negative@a: where = 0 if abs(gap) <= near else -1
    # ? sqrt-of-negative@b: where = 0 if abs(gap) <= near else -1
    # : Nothing keeps a ray that misses the sphere from the root: the program ends there. Return None first.
    if where == 1:
        return None
    m = -(ux * fx + uy * fy + uz * fz)
    # + centre-behind: if m < -slack: return None
    # ? foot-sign: m = ux * fx + uy * fy + uz * fz
    half = 0.0 if where == 0 else sqrt(abs(gap * (r + d)))
    # = half = 0.0 if where == 0 else sqrt(max(0.0, r * r - d * d))
    # ? sqrt-of-negative@b: half = 0.0 if where == 0 else sqrt(gap * (r + d))
    # ? sqrt-of-negative@a: half = 0.0 if where == 0 else sqrt(abs(r * r - d * d))
    # : The absolute value is taken under the root, "to be safe", so that a miss gets a point as well.
    # ? radius-not-squared: half = 0.0 if where == 0 else sqrt(abs(r - d * d))
    ways = ((m - half, 1), (m + half, -1))
    # ? far-root: ways = ((m + half, -1),)
    # ? entry-behind@e: ways = ((m - half, 1),)
    # @ What lies behind O
    # ? inside-is-miss: ways = ((m - half, 1),)
    # @ From inside
    # ? foot-for-root: ways = ((m, 1),)
    # ? reversed-order: ways = ((m + half, -1), (m - half, 1))
    # ? absolute-value: ways = ((abs(m - half), 1),) if m - half >= -near or m + half < 0 else ((m + half, -1),)
    for way, side in ways:
        if way < -slack:
            continue
        # ? line-for-ray: if False: continue
        # : The lesser root is answered even where the whole sphere is behind. A ray begins at t = 0.
        # ? line-for-ray: if m + half >= -slack and way < -slack: continue
        # : Where the whole sphere is behind the lesser root is answered, below 0. A ray begins at t = 0: None.
        # ? line-for-ray: if side > 0 and way < -slack: continue
        # : Where the whole sphere is behind the greater root is answered, below 0. A ray begins at t = 0: None.
        # ? origin-on-circle: if way <= slack: continue
        # ? entry-behind@e: pass
        # ? segment-for-ray: if way < -slack or way > length + slack: continue
        # @ goes on for ever
        place = way if way > slack else 0.0
        # = place = max(way, 0.0)
        # ? origin-on-circle: if way <= slack: return None
        # : With the origin on the sphere None is returned. t = 0 is allowed: 0 is the answer there.
        # ? disc-for-circle: place = 0.0 if hypot(fx, fy, fz) <= r + slack else way
        x, y, z = fx + way * ux, fy + way * uy, fz + way * uz
        # ? normal-at-origin: x, y, z = fx, fy, fz
        scale = side / r
        # ? not-flipped: scale = 1 / r
        # @ N faces the ray
        # ? inward-always: scale = -1 / r
        # ? outward-for-facing: scale = -side / r
        # ? not-divided-by-r: scale = side
        # @ the unit normal N
        # ? not-divided-by-r: scale = side / (r * r)
        # : The normal is divided by r². From the centre to the point is r long: divide by r.
        normal = (x * scale, y * scale, z * scale)
        # = normal = (side * x / hypot(x, y, z), side * y / hypot(x, y, z), side * z / hypot(x, y, z))
        # ? position-normalised: normal = (lambda p: tuple(side * v / (hypot(*p) or 1) for v in p))([C[0] + x, C[1] + y, C[2] + z])
        # ? direction-for-normal: normal = (-ux, -uy, -uz)
        return place / length, normal
        # ? distance-for-parameter: return place, normal
        # @ not a distance
        # ? floor-division: return place // length, normal
        # ? point-for-normal: return place / length, (C[0] + x, C[1] + y, C[2] + z)
        # ? swapped-answers: return normal, place / length
        # ? nested-answer: return (place / length, *normal)
    return None


def quadratic(C, r, O, D):
    "right"
    f = [o - c for o, c in zip(O, C)]
    a = dot(D, D)
    if a == 0 or r == 0:
        return None
    b = dot(f, D)
    # ? two-components: b = f[0] * D[0] + f[1] * D[1]
    # : f·D is of two terms. It has three: add fz·Dz.
    c = dot(f, f) - r * r
    # ? two-components: c = f[0] * f[0] + f[1] * f[1] - r * r
    # : f·f is of two terms. It has three: add fz².
    # ? wrong-sign: c = dot(f, f) + r * r
    # ? global-frame: c = dot(O, O) - 2 * dot(O, C) + dot(C, C) - r * r
    near = 1e-10 * max(r, *map(abs, f))
    k = (D[1] * f[2] - D[2] * f[1], D[2] * f[0] - D[0] * f[2], D[0] * f[1] - D[1] * f[0])
    disc = b * b - a * c
    # = disc = r * r * a - dot(k, k)
    # ? direction-not-normalised@y: disc = b * b - c
    gap = sqrt(dot(k, k) / a) - r
    where = 1 if gap > near else 0 if gap >= -near else -1
    # ? direction-not-normalised@y: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? equality: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? absolute-epsilon: where = 1 if disc < -{1e-12..1e-6/6} else 0 if disc <= {1e-12..1e-6/6} else -1
    if where == 1:
        return None
    root = 0.0 if where == 0 else sqrt(abs(disc))
    ts = ((-b - root) / a, (-b + root) / a)
    # ? direction-not-normalised@y: ts = (-b - root, -b + root)
    # ? unhalved: ts = ((-b - root) / (2 * a), (-b + root) / (2 * a))
    slack = near / sqrt(a)
    # ? parameter-epsilon: slack = {1e-6..1e-3/3}
    enters = ts[0] >= -slack
    # ? entry-behind: enters = True
    t = ts[0] if enters else ts[1]
    if t < -slack:
        return None
    p = [x + t * d for x, d in zip(f, D)]
    n = [x / r for x in p] if enters else [-x / r for x in p]
    return (t if t > slack else 0.0), n


def axis(C, r, O, D):
    "slope-intercept"
    f = [o - c for o, c in zip(O, C)]
    near = 1e-10 * max(r, *map(abs, f))
    if not any(D) or r == 0:
        return None
    # + slope-intercept: if D[0] == 0: return None
    # : A ray with no x, which has no slope, is answered with None. Write it as O + t·D.
    my, mz = D[1] / D[0], D[2] / D[0]
    # = my, mz = D[1] / (D[0] or 1e-12), D[2] / (D[0] or 1e-12)
    ny, nz = f[1] - my * f[0], f[2] - mz * f[0]
    a, b, c = 1 + my * my + mz * mz, my * ny + mz * nz, ny * ny + nz * nz - r * r
    disc = b * b - a * c
    if disc < -near * r * a:
        return None
    s = sqrt(abs(disc))
    found = []
    for x in ((-b - s) / a, (-b + s) / a):
        t = (x - f[0]) / (D[0] or 1e-12)
        found.append((t, (x / r, (my * x + ny) / r, (mz * x + nz) / r)))
    found.sort()
    (t0, n0), (t1, n1) = found
    slack = near / hypot(*D)
    if t0 >= -slack:
        return max(t0, 0.0), n0
    return (max(t1, 0.0), tuple(-v for v in n1)) if t1 >= -slack else None
