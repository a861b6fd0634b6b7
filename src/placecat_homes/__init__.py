"""Synthetic homes: furnished rooms, and rendered videos of walks through them.

``python -m placecat_homes`` renders the videos in data/ again. `placecat` does not import this package. No
other package needs the optional extra ``render``.
"""
