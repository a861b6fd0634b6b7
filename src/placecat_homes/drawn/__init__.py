"""Homes whose floor plans, light and walks the program draws from a seed."""
