"""Practice: what was judged before, what it shows that a person can do, and what to do next.

    events.py, history.py    what is kept of a person; the file that keeps it
    progress.py, review.py   what that shows: levels, skills, questions; what is due again
    syllabus.py              what there is to learn: sets, skills, the checklist
    cards.py, questions.py   cards and their decks; a card as it is asked
    quiz.py                  which cards come next, and the mock interview
    stub.py, solutions.py    the file a kata begins with, the solutions that are explained afterwards
    setter.py                a new kata, and what it needs for all of this

It stands above `judging` and below `report`, and prints nothing.
"""
