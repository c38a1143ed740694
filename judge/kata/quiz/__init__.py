"""Quiz cards: questions that are no kata, asked again before they are forgotten.

cards.py      what a card is, and the decks of cards beside the problems
question.py   a card that is asked: what is shown, and what an answer comes to
typed.py      reading what a person types
sources.py    what questions are made from: problems, their exact answers, chance
forms/        the forms of cards, one object each
choose.py     which cards come next
"""
