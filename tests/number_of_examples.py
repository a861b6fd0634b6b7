"""The number of examples in property-based tests."""

import hypothesis

IN_FULL = 40
"""Number of examples in a test that sets no number."""


def examples(number):
    """Scale a number of examples by the number in the profile divided by `IN_FULL`, but keep at least 5."""
    return max(min(number, 5), number * hypothesis.settings.default.max_examples // IN_FULL)
