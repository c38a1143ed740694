def ray_nearest(cx, cy, r, O, D):
    return None
