"""Fill memory with a list."""

rows = []
while True:
    rows.append([0] * 100_000)
