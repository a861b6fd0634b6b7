"""How fast each piece of `placecat` is, beside what a user would pick instead (``make bench``).

One module a piece in `pieces`, found because it is there; `scale` measures the stages at the size of
VPC-2009. `placecat` imports nothing of this package, and only it imports the peers, which the optional extra
``bench`` installs.
"""
