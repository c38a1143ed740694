"""one-by-one

The numbers are tried one by one. Guess the one in the middle.
"""

for guess in range(1, int(input()) + 1):
    print(guess, flush=True)
    if input() == "found":
        break
