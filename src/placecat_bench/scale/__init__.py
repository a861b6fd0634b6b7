"""Measure the stages' time, its growth, and their memory at the size of the thesis's home database.

`python -m placecat_bench.scale` draws features of that size from the outputs of `make repro`, runs the stages
at several sizes for the test homes of conf/scale.yaml, and writes reports/scale.csv, scale_growth.csv and
scale.json.
"""
