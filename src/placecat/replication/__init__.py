"""Plan and run a replication of the findings on more homes.

Before a run, it computes how many homes are needed to decide each finding. No stage uses this package.
"""
