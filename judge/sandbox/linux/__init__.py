"""Linux's own means of confinement, through ctypes: landlock, filters, prctl. Standard library only.

Every module here also runs inside the container, loaded from its code object (see bundle.py), so none may
read a file of the package.
"""
