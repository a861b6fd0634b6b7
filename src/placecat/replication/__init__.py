"""Plan and run a replication of the findings on more homes.

Before a run, the package can compute how many homes are needed to decide each finding. No stage uses it.
"""
