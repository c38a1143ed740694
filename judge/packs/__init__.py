"""Problems of ours as packages that other judges read: Kattis and ICPC, in the legacy format and in 2025-09.

schemas.py      types of answers and parameters as JSON, exact answers as the ends of what is accepted
cases.py        the tests
validators/     the programs that packages ship, two each; they import nothing of the judge
statement.py    the statement as LaTeX
metadata.py     names, uuid, problem.yaml
driver.py       a function made a program
programs.py     which programs a package holds, tried as it has them
package.py      all files of a package
write.py        writing them, whole or not at all
export.py       all of that for one problem
"""
