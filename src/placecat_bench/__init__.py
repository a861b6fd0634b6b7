"""Benchmarks of the pieces of `placecat`, compared with their best alternatives (``make bench``).

Each module of `pieces` benchmarks one piece, and `scale` measures the stages on as many frames as VPC-2009
has. `placecat` imports nothing from here. Only this package imports the alternatives ("peers"). The optional
``bench`` extra installs most of them.
"""
