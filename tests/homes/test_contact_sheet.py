"""The contact sheet chooses the view with the most detail for each place, and puts it in the right cell."""

import numpy as np

from placecat_homes.contact_sheet import draw, only, sharpest


def plain(value):
    return np.full((72, 128, 3), value, np.uint8)


def checked(cells):
    x, y = np.meshgrid(np.arange(128), np.arange(72))
    board = ((x // cells + y // cells) % 2 * 255).astype(np.uint8)
    return np.repeat(board[..., None], 3, axis=2)


def test_the_sharpest_view_of_each_place_is_chosen():
    frames = [plain(90), checked(32), checked(8), plain(20), checked(8)]
    views = sharpest(frames, ["kitchen", "kitchen", "kitchen", "bedroom", "corridor"], ["kitchen", "bedroom"])
    assert set(views) == {"kitchen", "bedroom"}
    assert np.array_equal(views["kitchen"], frames[2])
    assert np.array_equal(views["bedroom"], frames[3])


def test_a_view_can_be_chosen_by_hand():
    labels = ["kitchen", "kitchen", "bedroom", "kitchen"]
    assert only(labels, {"kitchen": 2}) == ["", "kitchen", "bedroom", ""]


def test_rows_are_homes_and_columns_are_places():
    views = {"home_1": {"kitchen": plain(10), "bedroom": plain(60)}, "home_2": {"bedroom": plain(110)}}
    sheet = draw(views, ["bedroom", "kitchen"], width=64)
    rows, columns = (30 + 18, 30 + 40 + 18), (30 + 32, 30 + 68 + 32)
    found = [[int(sheet[y, x, 0]) for x in columns] for y in rows]
    assert found == [[60, 10], [110, 255]]
