"""Where objects can stand, hang and lie in a room so that people can still walk through it."""
