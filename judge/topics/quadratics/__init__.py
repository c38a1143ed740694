"""Quadratic equations a·t² + 2·b·t + c = 0 with numbers that doubles hold: test cases in recipes.py."""
