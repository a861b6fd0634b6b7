"""Time and memory of the real stages at the size of the thesis's home database, and their growth.

`python -m placecat_bench.scale` draws features of that size from the outputs of `make repro`, runs the stages
for one test home at several sizes, and writes reports/scale.csv, scale_growth.csv and scale.json.
"""
