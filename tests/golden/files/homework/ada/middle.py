def middle(a, b):
    return (a + b) / 2
