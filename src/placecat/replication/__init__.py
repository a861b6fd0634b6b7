"""Plan and run a replication of the findings on more homes.

Before a run, the package computes how many homes decide each finding. No stage uses the package.
"""
