"""Speed of each piece of `placecat` beside its best alternative (``make bench``).

Each module of `pieces` is one piece; `scale` measures the stages at the size of VPC-2009. `placecat` imports
nothing from here, and only this package imports the peers, which the optional extra ``bench`` installs.
"""
