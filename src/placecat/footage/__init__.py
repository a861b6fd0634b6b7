"""Read frames and their timestamps from files."""
