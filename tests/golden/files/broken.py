def middle(a, b)
