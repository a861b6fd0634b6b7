"""Benchmarks of the stages at the size of the thesis's home database: time, its growth, and memory.

`python -m placecat_bench.scale` draws features for that size from the outputs of `make repro`. It runs the
stages at several sizes for the test homes in conf/scale.yaml, and writes reports/scale.csv, scale_growth.csv
and scale.json.
"""
