"""The report page in a real browser."""

import re

import cv2
import pytest

from browser import needs_chromium, open_page, screenshot

pytestmark = pytest.mark.xdist_group("pipeline")


@needs_chromium
def test_the_page_shows_every_table_and_its_console_is_clean(reproduced, tmp_path):
    folder, _, _ = reproduced
    page = folder / "reports/index.html"
    dom, console = open_page(page.as_uri(), tmp_path, "--dump-dom")
    assert console == []
    shown = {int(number) for number in re.findall(r'<section id="table-(\d+)">', dom)}
    assert shown == {5, 6, 7, 8, 9, 10, 23, 26, 29}
    section = dom[dom.index('id="table-26"') : dom.index('id="table-29"')]
    assert section.count('<th scope="row">') == 2 * 20
    measured = re.findall(r"<td>([\d.]*)</td>", section[: section.index("<details")])
    assert len(measured) == 20 * 7
    assert all(re.fullmatch(r"\d{1,3}\.\d\d", cell) for cell in measured if cell)
    assert measured.count("") == 20 * 2


@needs_chromium
def test_the_page_says_that_the_data_differs(reproduced, tmp_path):
    folder, _, _ = reproduced
    dom, _ = open_page((folder / "reports/index.html").as_uri(), tmp_path, "--dump-dom")
    assert "numbers do not compare" in re.sub(r"\s+", " ", dom)
    assert dom.count("on the VPC-2009 home database: other data, not comparable</summary>") == 9


def test_the_page_needs_no_server(reproduced):
    folder, _, _ = reproduced
    text = (folder / "reports/index.html").read_text()
    assert re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', text) == []


@needs_chromium
@pytest.mark.parametrize("width", [390, 1200])
def test_the_page_fits_its_window(reproduced, tmp_path, width):
    """Wide tables scroll inside the page; the page itself does not."""
    folder, _, _ = reproduced
    picture = cv2.imread(
        str(screenshot((folder / "reports/index.html").as_uri(), tmp_path, "page", width=width))
    )
    assert picture.shape[1] == width
    assert (picture[:, -3:] == picture[0, 0]).all(), "content reaches the edge of the window"
