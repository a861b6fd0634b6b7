"""Synthetic homes with furnished rooms, and rendered videos of walks through them.

``python -m placecat_homes`` re-renders the videos in data/. `placecat` does not import this package. No other
package needs the optional ``render`` extra.
"""
