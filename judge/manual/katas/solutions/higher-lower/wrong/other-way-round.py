"""other-way-round

After `higher` the guesses go down. The number is above the guess.
"""

low, high = 1, int(input())
answer = ""
while answer != "found":
    guess = (low + high) // 2
    print(guess, flush=True)
    answer = input()
    if answer == "lower":
        low = guess + 1
    elif answer == "higher":
        high = guess - 1
