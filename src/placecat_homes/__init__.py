"""The homes that come with the project: furnished rooms, filmed on rendered walks.

``python -m placecat_homes`` renders the videos of data/ again. `placecat` does not import this package, which
is the only one that needs the optional extra ``render``.
"""
