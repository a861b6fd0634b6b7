"""Numbers of examples in tests."""

import hypothesis

IN_FULL = 40
"""Number of examples in a test that does not choose it."""


def examples(number):
    """The number of examples, reduced like the number in the profile relative to `IN_FULL`; at least 5."""
    return max(min(number, 5), number * hypothesis.settings.default.max_examples // IN_FULL)
