"""Where things can stand, hang and lie in a room, so that everybody can still walk."""
