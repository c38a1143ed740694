"""vectorised-quadratic

The loop over the circles is numpy's, and so a constant factor quicker; there are n·m tests all the same. A structure
that leaves most circles out is quicker in plain Python than all of them in numpy.
"""

import numpy as np


def nearest_hits(circles, rays):
    x, y, r = np.array(circles, dtype=float).T
    answers = []
    for (ox, oy), (dx, dy) in rays:
        fx, fy = x - ox, y - oy
        near = 1e-10 * max(r.max(), np.abs(fx).max(), np.abs(fy).max())
        length = float(np.hypot(dx, dy))
        d = np.abs(dx * fy - dy * fx) / length
        foot = (dx * fx + dy * fy) / length
        half = np.sqrt(np.maximum((r - d) * (r + d), 0.0))
        half[np.abs(d - r) <= near] = 0.0
        s = np.where(foot - half >= -near, foot - half, foot + half)
        s[(d > r + near) | (s < -near)] = np.inf
        index = int(np.argmin(s))
        best = float(s[index])
        answers.append(None if best == np.inf else (index, (best if best > near else 0.0) / length))
    return answers
