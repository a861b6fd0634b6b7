"""Benchmarks of the pieces of `placecat` against their best alternatives (``make bench``).

Each module of `pieces` benchmarks one piece, and `scale` measures the stages at the size of VPC-2009.
`placecat` imports nothing from here. Only this package imports the alternatives ("peers"). The optional extra
``bench`` installs most of them.
"""
