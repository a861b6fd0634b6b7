"""Plan and run a replication of the findings on more homes.

Before a run, the package computes how many homes decide each finding, and how often the rule errs. No stage
uses the package.
"""
