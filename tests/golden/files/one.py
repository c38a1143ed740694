def line_count(cx, cy, r, A, B):
    return 1
