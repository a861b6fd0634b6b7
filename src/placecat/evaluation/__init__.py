"""Who trains on what, and how well it went."""
