"""The homes that come with the project: furnished rooms and walks through them, rendered.

``python -m placecat_homes`` makes the videos of data/ again. `placecat` imports nothing of this package, and
only it needs the optional extra ``render``.
"""
