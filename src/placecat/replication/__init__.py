"""Plan a replication: how many homes decide each finding, and how often the rule errs.

It is used before a run; no stage uses it.
"""
