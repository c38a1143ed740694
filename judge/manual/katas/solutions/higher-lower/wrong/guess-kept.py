"""guess-kept

After `higher` the guess is still one of the numbers that are left. Leave it out.
"""

low, high = 1, int(input())
answer = ""
while answer != "found":
    guess = (low + high) // 2
    print(guess, flush=True)
    answer = input()
    if answer == "higher":
        low = guess
    elif answer == "lower":
        high = guess - 1
