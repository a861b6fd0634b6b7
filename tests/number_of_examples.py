"""How many examples a test draws."""

import hypothesis

IN_FULL = 40
"""Examples of a test that does not choose their number."""


def examples(number):
    """So many examples, or as large a part of them as the profile has of `IN_FULL`, at least 5."""
    return max(min(number, 5), number * hypothesis.settings.default.max_examples // IN_FULL)
