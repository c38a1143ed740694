"""The mistakes that people make in a problem: read, rendered as programs, recognised in a submission.

thresholds.py   where its decisions turn, asked in a few series of calls
laws.py         what such thresholds follow: a size, none, several
epsilons.py     the kind of mistake that a law is
"""
