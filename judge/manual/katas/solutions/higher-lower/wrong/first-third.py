"""first-third

The guess is at a third of the numbers that are left. Guess the one in the middle.
"""

low, high = 1, int(input())
answer = ""
while answer != "found":
    guess = (low + high + low) // 3
    print(guess, flush=True)
    answer = input()
    if answer == "higher":
        low = guess + 1
    elif answer == "lower":
        high = guess - 1
