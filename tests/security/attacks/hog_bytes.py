"""Fill memory with bytes, touching them."""

rows = []
while True:
    rows.append(bytearray(b"x") * (8 << 20))
