def middle(a, b, c):
    return (a + b) / 2
