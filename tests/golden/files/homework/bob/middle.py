def middle(a, b):
    return '\ud800' if a else 10 ** 400
