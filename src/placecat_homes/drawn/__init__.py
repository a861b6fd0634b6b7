"""Homes whose floor plans, light and walks are drawn from a seed."""
