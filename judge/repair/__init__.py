"""Which small change of a wrong program makes it right: that change is the mistake, and it has a line."""
