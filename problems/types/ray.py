"""`ray`: (O, D), where it starts and where it goes."""

TYPE = "(point, vec2)"
