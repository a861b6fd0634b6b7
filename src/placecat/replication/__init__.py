"""The plan of a replication: how many homes decide each finding, and how often the rule errs.

No stage uses it: it is for before a run.
"""
