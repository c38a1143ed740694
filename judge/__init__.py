"""A judge and kata kit for circle-line geometry.

Imports point one way: cli → report → run → compare, data → problem → exact. `sandbox` knows nothing of
problems, `exact` knows nothing of judging.
"""

__version__ = "0.1.0"
