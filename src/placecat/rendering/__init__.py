"""Furnished rooms and walks through them, rendered: the homes that come with the project."""
