"""The setter's gate: what a kata's folders promise is checked."""
