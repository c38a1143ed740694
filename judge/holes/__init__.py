"""Looking for what a kata's data lack: wrong programs that they accept, each proved by a valid case."""
