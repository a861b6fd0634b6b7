"""Benchmarks of the stages at the size of the thesis's home database: run time, how it grows, and memory.

`python -m placecat_bench.scale` draws features for that size from the outputs of `make repro`. It runs the
stages at several sizes on the test homes in conf/scale.yaml, and writes reports/scale.csv, scale_growth.csv
and scale.json.
"""
