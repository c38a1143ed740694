"""`integer-ray`: (O, D) in integers."""

TYPE = "(integer-point, integer-point)"
