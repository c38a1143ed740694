"""A driver a language: the program around a learner's function that reads cases and writes answers.

    declared(draft)    how the function is declared, for a stub and for whoever declares it otherwise
    frame(draft, words)    what stands before that in a file to begin with, and a body that says `words`
    driver(draft)      the driver's file name and its text

The lines that a driver reads and writes are those of `judge.sandbox.calls`. It begins again at the next number
of cases until its input ends. Nothing in it is secret, and it is trusted with nothing: it runs where the
function runs, and is measured and compared from outside. The function's own prints go to stderr, a `main` that
its file has is not run, and a type of the problem's that its file defines is taken.
"""
