"""The report page of a complete run, in a real browser."""

import json
import re

import pytest

from browser import evaluate, evaluate_all, needs_chromium

pytestmark = pytest.mark.xdist_group("pipeline")


@pytest.fixture
def page(reproduced):
    return reproduced[0] / "reports/index.html"


@needs_chromium
def test_the_page_shows_every_table_and_figure_and_its_console_is_clean(page, tmp_path):
    found, console = evaluate(
        page,
        tmp_path,
        """
        const tables = {};
        const drawn = (selector) =>
            [...document.querySelectorAll(selector)].filter((one) => one.naturalWidth > 100).length;
        for (const one of document.querySelectorAll("section.table:is([id^=table-], [id^=addition-])"))
            tables[one.id] = [...one.querySelectorAll("td:not(.thesis)")].map((cell) =>
                [cell.textContent, cell.dataset.mark ?? ""]);
        return {
            tables,
            figures: [...document.querySelectorAll("figure")].map((one) => one.id),
            images: drawn("figure img"),
            charts: drawn("#speed img"),
            findings: document.querySelectorAll("#ledger tbody tr").length,
        };
        """,
    )
    assert console == []
    written = {path.stem for path in (page.parent / "tables").glob("*.csv")}
    assert len(found["tables"]) == len(written) >= 31
    assert {f"table-{number}" for number in range(1, 32)} <= set(found["tables"])
    for cells in found["tables"].values():
        assert cells
        # Each cell has a number, or the letter of a footnote that explains why the number is missing.
        assert all(re.fullmatch(r"\d{1,3}\.\d\d", number) or mark for number, mark in cells)
    assert sum(number != "" for cells in found["tables"].values() for number, _ in cells) > 500
    figures = json.loads((page.parent / "figures/figures.json").read_text())
    added = [f"addition-{one['name']}".replace("_", "-") for one in figures if one["number"] is None]
    anchors = [f"figure-{one['number']}" for one in figures if one["number"] is not None]
    assert sorted(found["figures"]) == sorted([*anchors, *added])
    assert found["images"] == sum(figure["file"] is not None for figure in figures) > 0
    # This is the chart of the benchmarks in git.
    assert found["charts"] == 1
    assert found["findings"] == 34


@needs_chromium
def test_the_page_fits_its_window(page, tmp_path):
    """Wide tables scroll inside the page; the page itself does not."""
    script = "const root = document.documentElement; return [innerWidth, root.clientWidth, root.scrollWidth];"
    found, _ = evaluate_all(page, tmp_path, [(script, 390), (script, 1200)])
    assert [window for window, _, _ in found] == [390, 1200]
    for _, inner, needed in found:
        assert needed == inner


def test_the_page_says_that_the_data_differ(page):
    text = page.read_text()
    assert text.count("the data differ, and the shading also reflects this") == 31


def test_the_page_needs_no_server(page):
    links = re.findall(r'(?:src|href)="(?!#|data:)([^"]*)"', page.read_text())
    # The page is complete without these links.
    assert sorted(links) == sorted(f"figures/{path.name}" for path in (page.parent / "figures").glob("*.pdf"))


@needs_chromium
def test_every_cell_opens_its_explanation(page, tmp_path):
    found, console = evaluate(
        page,
        tmp_path,
        """
        const { cells } = JSON.parse(document.getElementById("explanations").textContent);
        const explained = [...document.querySelectorAll(".explained")];
        // The number of the cell stands in its explanation: both count alike.
        const strange = explained.filter((one) => {
            const [, text] = cells[one.id].find((item) => item[0] === "here");
            return one.textContent !== "" && Number.parseFloat(text) !== Number.parseFloat(one.textContent);
        });
        const press = (key) => document.activeElement.dispatchEvent(
            new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
        document.getElementById("table_26.9.3").focus();
        press("ArrowRight");
        press("ArrowDown");
        const reached = document.activeElement.id;
        press("Enter");
        const dialog = document.getElementById("explanation");
        const shown = [dialog.open, dialog.querySelector("code").textContent, location.hash];
        const fits = dialog.scrollWidth <= dialog.clientWidth;
        dialog.querySelector("button").click();
        return {
            cells: Object.keys(cells).length,
            explained: explained.length,
            strange: strange.map((one) => one.id),
            reached, shown, fits, closed: !dialog.open,
        };
        """,
    )
    assert console == []
    assert found["explained"] == found["cells"] > 2000
    assert found["strange"] == []
    assert found["reached"] == "table_26.10.4"
    assert found["shown"] == [True, "placecat explain table_26.10.4", "#table_26.10.4"]
    assert found["fits"]
    assert found["closed"]
