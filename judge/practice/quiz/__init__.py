"""Quiz cards: questions that need no code, asked again before they are forgotten.

cards.py      what a card is, and the decks of cards beside the problems
questions.py  a card that is asked: what is shown, and what an answer comes to
typed.py      reading what a person types
choose.py     which cards come next, and what to practise afterwards
"""
