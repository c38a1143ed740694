"""Figures in small integers, and what is done to them: none of it knows which problem asks.

figure.py     a circle with points and vectors, and the changes that keep what a recipe built
lines.py      a circle and a line in integers, tangent or missing it by a hair or by a mile
posing.py     from a level figure to any place, direction, size and number type
numbers.py    number theory: Bézout, Pythagorean triples, sums of two squares, Pell's equation
"""
