def middle(a, b):
    print('a is', a)
    return (a + b) // 2
