"""How fast each piece is, beside what a user would pick instead (``make bench``).

One module a piece in `pieces`, found because it is there. Nothing else of the project imports this package,
and only it imports the peers, which the optional extra ``bench`` installs.
"""
