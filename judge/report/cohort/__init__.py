"""What a whole class is shown: on the screen, as a gradebook and as a page.

parts.py        what is shown: frozen values
lines.py        the cohort on the screen
gradebook.py    a line a student, as CSV
page.py         one HTML page, by a template beside those of `judge.report.page`
"""
