"""Types of answers and of parameters: deciding an answer, showing it, and telling one wrong one from another.

`answers` has what `solve` returns, `types` what types there are, `grammar` the language in which they are
written; `check` decides.
"""
