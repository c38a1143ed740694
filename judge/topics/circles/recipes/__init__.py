"""Recipes of test cases: each draws a figure that has one property, and checks that it has.

counting.py     how often a circle and a line meet
endpoints.py    which of the common points lie on a segment
rays.py         which of them a ray meets first
steps.py        first steps: a few points and perhaps a circle, in whole numbers
"""
