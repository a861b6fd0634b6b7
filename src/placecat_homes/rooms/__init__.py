"""The furniture of each kind of room."""
