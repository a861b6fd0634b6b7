"""Place objects in a room while leaving space for people to walk through it."""
