"""A problem as a Kattis package, in the legacy format and in that of 2025-09.

forms.py        types of answers and parameters as JSON, exact answers as the ends of what is accepted
validators/     the programs that packages ship, two each; they import nothing of the judge
statement.py    the statement as LaTeX
metadata.py     names, uuid, problem.yaml
driver.py       a function made a program
trial.py        which verdict a program gets as the package has it
programs.py     which programs a package holds
package.py      all files of a package
place.py        writing them, whole or not at all
"""
