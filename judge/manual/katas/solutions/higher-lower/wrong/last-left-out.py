"""last-left-out

The highest number is never guessed. It may be the one.
"""

low, high = 1, int(input()) - 1
answer = ""
while answer != "found":
    guess = (low + high) // 2
    print(guess, flush=True)
    answer = input()
    if answer == "higher":
        low = guess + 1
    elif answer == "lower":
        high = guess - 1
