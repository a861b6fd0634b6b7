"""The real stages at the size of the thesis's home database: how long, how much memory, how both grow.

`python -m placecat_bench.scale` builds features of that size out of those that `make repro` left, runs the
stages for one test home at several sizes, and writes reports/scale.csv, scale_growth.csv and scale.json.
"""
