"""What is in a room of each kind."""
