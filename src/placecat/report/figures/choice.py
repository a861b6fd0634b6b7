"""Which home a figure shows."""

from typing import TYPE_CHECKING

from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from placecat.report.run import Run


def home_of(run: "Run", number: int) -> str:
    """The home of a number from 1 on, as the thesis counts; the last one where there are fewer.

    Raises
    ------
    PlacecatError
        If the number is below 1.
    """
    if number < 1:
        raise PlacecatError(f"homes of figures are counted from 1: there is no home {number}")
    return run.homes[min(number, len(run.homes)) - 1]
