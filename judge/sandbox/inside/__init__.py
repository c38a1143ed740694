"""What runs inside the container: the fork server and its children. Standard library only.

The judge loads these modules from their code objects (see parcels.py), never from a path, so that nothing of
the package needs to be visible in there.
"""
