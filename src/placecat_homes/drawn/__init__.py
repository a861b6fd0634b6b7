"""Homes whose floor plans, lighting and walks are drawn from a seed."""
