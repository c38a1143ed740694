"""Recipes of test cases: each draws a figure that has one property, and checks that it has."""
