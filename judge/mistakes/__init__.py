"""What is known of mistakes: a submission's own thresholds, measured, and the names that follow from them.

thresholds.py   where its decisions turn, asked in a few series of calls
laws.py         what such thresholds follow: a size, none, several
epsilons.py     the kind of mistake that a law is
"""
