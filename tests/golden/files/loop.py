def middle(a, b):
    while a != b:
        a += 0
    return a
