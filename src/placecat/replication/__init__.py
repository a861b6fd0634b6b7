"""Plan and run a replication of the findings on more homes.

Before a run it computes how many homes decide each finding, and how often the rule errs. No stage uses it.
"""
