"""Homes with random floor plans, light and walks, drawn from a seed."""
