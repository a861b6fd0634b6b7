"""The report page, from made-up results, as text and in a real browser."""

import re
from dataclasses import replace

import cv2
import numpy as np
import pandas as pd
import pytest

import made_report
from browser import evaluate, evaluate_all, needs_chromium, screenshot
from made_report import DATASET, settings
from placecat.report.page import Figure, Table, duration, page_html
from placecat.thesis.notes import Kind, Note


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    target = tmp_path_factory.mktemp("page") / "index.html"
    target.write_text(page_html(made_report.report()), encoding="utf-8")
    return target


def small_report():
    """A report with one table and no figures, for parts that do not depend on them."""
    return made_report.report(tables=[5], figures=[])


_ASKED = []


def asked(body, width=1200):
    """Add a script to those that `answers` runs, and return its number."""
    _ASKED.append((body, width))
    return len(_ASKED) - 1


@pytest.fixture(scope="module")
def answers(page, tmp_path_factory):
    """The results of all scripts, each in a page of its own. Starting the browser takes most of the time."""
    found, console = evaluate_all(page, tmp_path_factory.mktemp("answers"), _ASKED)
    assert console == []
    return found


STATE = """
const click = (table, column) => document.querySelectorAll(`#${table} .sort`)[column].click();
const shown = (table, column) => [...document.querySelectorAll(`#${table} tbody tr:not(.group)`)]
    .filter((row) => !row.hidden).map((row) => row.cells[column].textContent);
const type = (input, text) => { input.value = text; input.dispatchEvent(new Event("input")); };
"""


def text_of(html):
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", "", html))


def part_of(html, anchor):
    start = html.index(f'id="{anchor}"')
    return html[start : html.index("</section>", start)]


PARTS = asked("""
        const ids = (selector) => [...document.querySelectorAll(selector)].map((one) => one.id);
        const cells = {};
        for (const one of document.querySelectorAll("section.table[id^=table-]"))
            cells[one.id] = one.querySelectorAll("td.thesis").length;
        return {
            tables: ids("section.table[id^=table-]"), figures: ids("figure"), cells,
            broken: [...document.images].filter((one) => one.naturalWidth !== 260).length,
            images: document.images.length,
            alts: [...document.images].map((one) => one.alt),
            lost: [...document.querySelectorAll("a")].filter((one) => !document.querySelector(one.hash))
                .length,
            links: document.querySelectorAll("nav a").length,
            findings: document.querySelectorAll("#ledger tbody tr").length,
            doubled: ids("[id]").length - new Set(ids("[id]")).size,
        };
        """)


@needs_chromium
def test_the_page_has_every_table_and_figure_and_logs_nothing(answers):
    found = answers[PARTS]
    assert found["tables"] == [f"table-{number}" for number in range(1, 32)]
    before, after = list(range(1, 11)), [12, 13, 14, 11, 15, 16, 17, 18, 19, 20]
    added = "addition-figure-how-sure"
    assert found["figures"] == [*(f"figure-{number}" for number in [*before, *after]), added]
    assert found["images"] == 22  # not figure 20, which has a reason instead; speed and scale have charts
    assert found["broken"] == 0
    assert found["alts"][0] == "What figure 1 shows."
    published = made_report.published_tables().groupby("table").size()
    for number, count in published.items():
        assert found["cells"][f"table-{number}"] >= count
    assert (found["lost"], found["doubled"], found["findings"]) == (0, 0, 34)
    assert found["links"] > 31 + 20


WIDE = """
        document.querySelectorAll("details").forEach((one) => (one.open = true));
        const inside = (one) => one.closest(".scroll, pre");
        const right = document.documentElement.clientWidth;
        const out = [...document.body.querySelectorAll("*")].filter(
            (one) => !inside(one) && one.getBoundingClientRect().right > right + 1);
        return {width: innerWidth, scroll: document.documentElement.scrollWidth,
                out: out.map((one) => `${one.tagName}#${one.id}.${one.className}`)};
        """
WIDTHS = {width: asked(WIDE, width) for width in (390, 800, 1280, 1700)}


@needs_chromium
@pytest.mark.parametrize("width", WIDTHS)
def test_only_tables_scroll_sideways(answers, width):
    found = answers[WIDTHS[width]]
    assert found["width"] == width
    assert found["out"] == []
    assert found["scroll"] <= width


COPY = """
const copied = [];
Object.defineProperty(navigator, "clipboard", {value: {writeText: async (text) => copied.push(text)}});
for (const id of %s) {
    const button = document.querySelector(`#${id} button.copy`);
    if (button.hidden) throw "hidden";
    button.click();
    await new Promise((done) => setTimeout(done, 10));
    if (button.textContent !== "Copied") throw button.textContent;
}
return copied;
"""
COPIED_IDS = [
    "table-5",
    "table-4",
    "addition-rvm",
    "ledger",
    "headline",
    "in-text-numbers",
    "frames",
    "comparisons",
]
COPIED = asked(COPY % COPIED_IDS)


@needs_chromium
def test_tables_copy_as_lines_of_tab_separated_cells(answers):
    texts = answers[COPIED]
    tables = {
        name: [line.split("\t") for line in text.splitlines()]
        for name, text in zip(COPIED_IDS, texts, strict=True)
    }
    for rows in tables.values():
        assert len({len(row) for row in rows}) == 1

    shown = next(one.cells for one in made_report.report().tables if one.settings["number"] == 5)
    head, *rows = tables["table-5"]
    assert head[:3] == ["", "Home 1 measured", "Home 1 published"]
    assert head[-1] == "Average published"
    assert [row[0] for row in rows] == ["naive Bayes", "SVM"]
    numbers = [(float(row[i]), float(row[i + 1])) for row in rows for i in range(1, 15, 2)]
    assert numbers == list(zip(shown["measured"], shown["published"], strict=True))

    head, *rows = tables["table-4"]
    assert head[:4] == ["", "", "31 measured", "31 published"]
    assert [row[:2] for row in rows[2:4]] == [
        ["Naive Bayes", "Average"],
        ["First-Order Dependency Tree", "Home 1"],
    ]
    assert rows[3][-1] == "n/a"

    assert tables["addition-rvm"] == [
        ["", "Home 1", "Average"],
        ["RVM", "30.50", "31.25"],
        ["SVM", "33.00", ""],
    ]
    head, first, *_ = tables["ledger"]
    assert head[:7] == ["No.", "Section", "Finding", "Verdict", "Difference", "Low", "High"]
    assert head[7:] == ["Units", "Measured", "Published", "Reason"]
    ledger = made_report.findings().iloc[0]
    assert first[3:7] == [
        ledger["verdict"],
        *(f"{ledger[name]:.2f}" for name in ("difference", "low", "high")),
    ]
    assert tables["in-text-numbers"][1][:5] == [
        "4.2 gist without color",
        "without colour",
        "Home 6",
        "30.11",
        "35.41",
    ]
    assert tables["frames"][1] == ["Home 1: home_1", *["100"] * 5, "20"]


UNCOPIED = asked("""
        Object.defineProperty(navigator, "clipboard", {value: undefined});
        const button = document.querySelector("#table-5 button.copy");
        button.click();
        await new Promise((done) => setTimeout(done, 10));
        return [button.textContent, getSelection().toString()];
        """)


@needs_chromium
def test_without_a_clipboard_the_table_is_selected(answers):
    found = answers[UNCOPIED]
    assert found[0] == "Selected"
    assert "naive Bayes" in found[1]
    assert "First-Order" not in found[1]


SHADES = asked("""
    const value = (one) => getComputedStyle(one).backgroundColor.match(/[0-9]+/g).slice(0, 3).map(Number);
    const ink = (one) => getComputedStyle(one).color.match(/[0-9]+/g).slice(0, 3).map(Number);
    return [...document.querySelectorAll(".legend span[class]")].map((one) => [value(one), ink(one)]);
    """)


@needs_chromium
def test_shades_are_visible_and_distinct(answers):
    """Each shade has a different background with readable text in both the light and the dark theme."""

    def luminance(color):
        linear = [
            one / 12.92 if one <= 0.04045 else ((one + 0.055) / 1.055) ** 2.4 for one in np.array(color) / 255
        ]
        return float(np.dot(linear, [0.2126, 0.7152, 0.0722]))

    found = answers[SHADES]
    assert len(found) == 8
    assert len({tuple(background) for background, _ in found}) == 8
    for background, ink in found:
        low, high = sorted([luminance(background), luminance(ink)])
        assert (high + 0.05) / (low + 0.05) > 4.5
    # Blue is above and orange below. Every kind of colour vision distinguishes them: blue and red swap.
    assert all(background[0] > background[2] for background, _ in found[:4])
    assert all(background[0] < background[2] for background, _ in found[4:])


@needs_chromium
def test_the_page_fits_a_phone(page, tmp_path):
    picture = cv2.imread(str(screenshot(page.as_uri(), tmp_path, "phone", width=390, height=800)))
    assert picture.shape[:2] == (800, 390)
    assert (picture[:, -5:] == picture[0, 0]).all(), "content reaches the edge of the window"
    assert picture.std() > 10


def test_the_page_is_self_contained_and_deterministic(page):
    html = page.read_text(encoding="utf-8")
    assert re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', html) == []
    assert "url(" not in html
    assert "@import" not in html
    assert html == page_html(made_report.report())
    assert not re.search(r"20\d\d-\d\d-\d\d", html)


def test_the_page_works_without_scripts(page):
    html = re.sub(r"<script>.*?</script>", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    # Without scripts, the controls for copying, search and theme are hidden.
    assert html.count('<button class="copy" type="button" hidden>') == html.count("<button") - 1
    assert '<div class="tools" hidden>' in html
    assert "hidden" not in part_of(html, "table-5").replace(" hidden>Copy", "")


def test_the_summary_states_the_main_numbers(page):
    summary = text_of(part_of(page.read_text(encoding="utf-8"), "summary"))
    table = next(one.cells for one in made_report.report().tables if one.settings["number"] == 26)
    averages = table[table["column"] == "Average"].set_index(["group", "row"])["measured"]
    group = "5-5-1, all cues"
    cues = averages[group].drop(["Integration", "HMM"])
    integration, smoothed = averages[group, "Integration"], averages[group, "HMM"]
    assert (
        f"5-5-1, all cues: the best single cue is {cues.idxmax()} at {cues.max():.2f}%; integration "
        f"reaches {integration:.2f}%, and {smoothed:.2f}% when smoothed over time. In the "
        "thesis, the best is Centrist at 43.99%; integration reaches 45.71%, and 47.53% when smoothed."
    ) in summary
    assert "6 homes with 3,120 frames, of which 3,000 show one of 5 places" in summary
    (of_best, best), highest = averages.idxmax(), averages.max()
    assert f"Best system{highest:.2f}% {best}, {of_best}: average accuracy over homes in Table 26," in summary
    assert "Table 26, on made-up homes. Chance is 20%." in summary
    counts = made_report.findings()["verdict"].value_counts()
    holds, fails, undecided = (counts[verdict] for verdict in made_report.VERDICTS)
    assert (
        f"Of the thesis’s 34 findings, {holds} hold, {fails} do not hold, and {undecided} are undecided"
    ) in summary
    assert "1 home is used for testing. In “5-5-1”, the cues are trained on the same 5 homes" in summary
    assert "as the integration. “All cues” are the single cues in Table 26. “HMM” is the hidden" in summary
    assert (
        "41.87% for Centrist, 46.78% for Centrist filtered over time, and 39.8% for SIFT. The thesis’s "
        "numbers are also from that database. It consists of real homes, which are not the homes of this run."
    ) in text_of(page.read_text(encoding="utf-8"))


def test_the_summary_depends_on_the_data():
    report = made_report.report(tables=[26], figures=[])
    assert "None" not in text_of(part_of(page_html(report), "summary"))
    other = DATASET | {"note": "Only <made up>.", "homes": DATASET["homes"][:4]}
    html = page_html(replace(report, dataset=other | {"thesis_data": "VPC-2009 home database"}))
    summary = text_of(part_of(html, "summary"))
    assert "show one of 5 places.Only &lt;made up&gt;." in summary
    assert "stay the same here, with 4 homes." in summary
    assert "not directly comparable" not in text_of(html)


def test_a_cell_shows_its_difference_and_spread():
    table = made_report.cells(5)
    for index, difference in enumerate([0.5, 3.0, -7.0, 12.0, -25.0]):
        table.loc[index, "measured"] = table.loc[index, "published"] + difference
    table.loc[1, ["spread", "seeds"]] = [1.25, 2]
    html = page_html(replace(small_report(), tables=[Table(settings(5), table, DATASET)]))
    cells = re.findall(r"<td([^>]*)>[\d.]+</td><td class=\"thesis\"", part_of(html, "table-5"))
    assert [re.findall('class="([^"]*)"', one) for one in cells[:5]] == [
        [],
        ["above-1"],
        ["below-2"],
        ["above-3"],
        ["below-4"],
    ]
    assert 'title="+3.00 points; 2 seeds, 1.25 apart"' in cells[1]
    assert 'title="−7.00 points"' in cells[2]


def test_every_table_names_its_data(page):
    html = page.read_text(encoding="utf-8")
    for number in range(1, 32):
        said = text_of(part_of(html, f"table-{number}"))
        assert (
            "Here: made-up homes. Thesis: VPC-2009 home database; the data differ, and the shading also"
            in said
        )
    same = Table(settings(5), made_report.cells(5), DATASET | {"thesis_data": "VPC-2009 home database"})
    said = text_of(part_of(page_html(replace(small_report(), tables=[same])), "table-5"))
    assert "Thesis: VPC-2009 home database." in said
    assert "Measured on made-up homes." in text_of(part_of(html, "addition-rvm"))


def test_missing_parts_have_reasons(page):
    html = page.read_text(encoding="utf-8")
    addition = part_of(html, "addition-rvm")
    assert '<td data-mark="a"></td>' in addition
    assert "a too few frames." in text_of(addition)
    assert "Not drawn: this run has no university." in text_of(html)
    assert "this data has no such cue" in text_of(part_of(html, "ledger"))


def test_names_are_escaped():
    evil = "<b onclick=x>&\"'"
    table = made_report.cells(5)
    table["row"] = table["row"].replace("SVM", evil)
    report = small_report()
    count = len(report.in_text)
    html = page_html(
        replace(
            report,
            tables=[Table(settings(5, evil), table, DATASET | {"title": evil})],
            figures=[Figure(3, evil, made_report.png()), Figure(4, evil, None, evil)],
            findings=report.findings.assign(claim=evil, reason=evil),
            in_text=report.in_text.assign(quantity=evil, notes=[(Note(Kind.MEASURED, evil),)] * count),
            settings=evil,
            data_version=evil,
        )
    )
    assert "<b onclick" not in html
    assert html.count("&lt;b onclick") >= 9


def test_the_page_shows_all_settings(page):
    html = page.read_text(encoding="utf-8")
    blocks = re.findall(r"<pre>(.*?)</pre>", html, flags=re.DOTALL)
    assert blocks == ["dataset:\n  name: homes\n  title: a &lt; b &amp; c", "smoothing:\n  step: 1"]
    assert html.count("0123456789abcdef0123456789abcdef.dir") == 2


def test_times_come_from_the_stored_record(page):
    said = text_of(part_of(page.read_text(encoding="utf-8"), "times"))
    assert "on made-up homes, which took 4 min 3 s on 2 cores" in said
    without = page_html(replace(small_report(), times=None))
    assert "No times are stored" in text_of(part_of(without, "times"))


def test_missing_parts_of_a_run_leave_no_empty_sections():
    report = small_report()
    html = page_html(
        replace(
            report,
            tables=report.tables[:1],
            findings=report.findings[:0],
            comparisons=report.comparisons[:0],
            in_text=report.in_text[:0],
        )
    )
    assert re.findall(r'<section id="([^"]*)"', html) == [
        "summary",
        "data",
        "section-4-2",
        "speed",
        "scale",
        "times",
        "settings",
    ]
    assert "headline" not in re.findall(r'id="([^"]*)"', html)
    contents = html[html.index("<nav") : html.index("</nav>")]
    assert re.findall(r'href="#([^"]*)"', contents) == [
        "data",
        "section-4-2",
        "table-5",
        "speed",
        "scale",
        "times",
        "settings",
    ]


def test_tables_and_figures_without_a_section_come_last():
    report = small_report()
    other = Table(settings(40), made_report.cells(5), DATASET)
    html = page_html(
        replace(report, tables=[other, *report.tables], figures=[Figure(21, "More", made_report.png())])
    )
    assert html.index('id="additions"') < html.index('id="table-40"') < html.index('id="addition-rvm"')
    assert html.index('id="addition-rvm"') < html.index('id="figure-21"')


def test_the_ledger_draws_intervals_on_one_axis():
    findings = pd.DataFrame(
        {
            "number": [1, 2],
            "section": "4.2",
            "claim": "c",
            "published": "",
            "measured": "",
            "difference": [-40.0, 5.0],
            "low": [-50.0, 0.0],
            "high": [-30.0, 12.5],
            "units": "6 homes",
            "verdict": "holds",
            "reason": "",
        }
    )
    html = page_html(replace(small_report(), findings=findings))
    ranges = re.findall(r'<line class="range" x1="([\d.]+)" x2="([\d.]+)"', html)
    assert ranges == [("4.0", "4.0"), ("50.0", "73.0")]
    assert re.findall(r'<circle cx="([\d.]+)"', html) == ["4.0", "59.2"]
    assert "on an axis that extends 25 points on either side of 0" in text_of(html)


@pytest.mark.parametrize(
    "seconds, expected",
    [
        (0, "0.0 s"),
        (0.84, "0.8 s"),
        (59.6, "1 min"),
        (243.4, "4 min 3 s"),
        (3600, "1 h"),
        (7512, "2 h 5 min"),
    ],
)
def test_durations(seconds, expected):
    assert duration(seconds) == expected


def test_the_benchmark_table_explains_missed_targets(page):
    html = page.read_text(encoding="utf-8")
    part = text_of(part_of(html, "speed-table"))
    cells = ("HOG", "25 regions", "1 ms", "OpenCV: compute 4.14.0", "1.7 ms", "1.7 (1.6 to 1.9)")
    assert "".join(cells) + "at least 2x fasterno" in part
    assert "spent on: resizing 61%" in part
    assert part.count("spent on") == 1
    assert "A processor &lt;fast&gt;, Python 3.11.7, numpy 2.3.5" in html


def test_without_benchmarks_the_page_says_how_to_measure():
    html = page_html(replace(small_report(), speed=None))
    assert "make bench" in text_of(part_of(html, "speed"))
    assert "speed-table" not in html


def test_the_scale_table_has_every_stage_and_the_time_of_a_full_run(page):
    html = page.read_text(encoding="utf-8")
    rows = re.findall(r"<tr.*?</tr>", part_of(html, "scale-table"), re.S)
    assert [text_of(row.replace("<td", " <td")) for row in rows[1:]] == [
        "codebooks 10.0 20.0 40.0 12.0 2.00 1.00 1.00",
        "trials 10.0 40.0 160.0 50.0 4.00 2.00 2.00",
        "scores 1.5 1.5 1.5 1.0 0.20 0.00 0.00",
        "all 21.5 61.5 201.5 63.0 4.00 1.70 1.80",
    ]
    assert "would take about 12.3 hours" in text_of(html)
    assert "1 min 3 s and used at most 4.0 GiB (trials@gist), with 2 workers on 2 cores" in text_of(html)


def test_without_a_scale_run_the_page_says_how_to_measure():
    html = page_html(replace(small_report(), scale=None))
    assert "make bench-scale" in text_of(part_of(html, "scale"))


SORTED = asked(
    STATE
    + """
        const states = [];
        for (let i = 0; i < 4; i++) {
            const heads = [...document.querySelectorAll("#table-4 [aria-sort]")];
            states.push([heads.map((one) => one.ariaSort), shown("table-4", 1)]);
            document.querySelectorAll("#table-4 thead tr")[1].querySelector(".sort").click();
        }
        click("ledger", 1);
        return {states, sections: shown("ledger", 1), numbers: shown("ledger", 0)};
        """
)


@needs_chromium
def test_a_column_is_sorted_numerically_within_each_group(answers):
    found = answers[SORTED]
    assert [heads for heads, _ in found["states"]] == [[], ["ascending"], ["descending"], []]
    first, up, down, last = (values for _, values in found["states"])
    assert first == last
    assert sorted(first) == sorted(up) == sorted(down)
    table = next(one.cells for one in made_report.report().tables if one.settings["number"] == 4)
    start = 0
    for _, part in table[table["column"] == table["column"].iloc[0]].groupby("group", sort=False):
        end = start + len(part)
        # The average stays below the homes.
        homes = part[part["row"] != "Average"]["measured"].sort_values()
        assert [float(value) for value in up[start:end]][: len(homes)] == list(homes)
        assert [float(value) for value in down[start:end]][: len(homes)] == list(homes[::-1])
        start = end
    # Section 4.10 comes after 4.4. Findings of the same section stay in order.
    assert found["sections"] == ["4.4"] + ["4.10"] * 33
    assert found["numbers"] == ["34", *(str(number) for number in range(1, 34))]


FILTERED = asked(
    STATE
    + """
        type(document.querySelector("#ledger .filter"), "CLAIM 12:");
        const visible = [...document.querySelectorAll("#ledger tbody tr")]
            .filter((row) => row.getBoundingClientRect().height).map((row) => row.id);
        const count = document.querySelector("#ledger .title output").textContent;
        location.hash = "finding-3";
        await new Promise((done) => setTimeout(done, 50));
        return [visible, count, shown("ledger", 0).length, !!document.querySelector("#addition-rvm .filter")];
        """
)


@needs_chromium
def test_rows_can_be_filtered_and_links_reveal_hidden_rows(answers):
    found = answers[FILTERED]
    assert found == [["finding-12"], "1 of 34", 34, False]


def test_verdicts_on_more_homes_follow_each_finding():
    report = small_report()
    more = report.findings[["number", "difference", "low", "high", "units", "verdict"]].assign(
        units="24 homes", verdict="holds", replicated=True
    )
    more.loc[more["number"] == 27, "replicated"] = False
    replication = {
        "title": "24 homes <drawn>",
        "homes": 24,
        "groups": 4,
        "level": 0.98,
        "verdicts": {"holds": 34, "does not hold": 0, "undecided": 0},
        "findings": more,
    }
    shown = text_of(page_html(replace(report, replication=replication)))
    assert "On 24 other homes, 34 hold, 0 do not, and 0 are undecided." in shown
    assert "its verdict on the 24 homes of the data set “24 homes &lt;drawn&gt;”." in shown
    assert "one or two of its six homes (then one or two of each group count), or" in shown
    difference, low, high = (f"{more[name][0]:.2f}" for name in ("difference", "low", "high"))
    assert f"On 24 homes: holds {difference} ({low} to {high}, 24 homes)" in shown
    assert shown.count("On 24 homes: holds") == 33
    without = text_of(page_html(report))
    assert "On 24" not in without
    assert "one or two of its six homes, or if a result cannot be computed for every home" in without


def test_a_finding_judged_from_the_cases_of_all_comparisons_says_so():
    report = small_report()
    twice = pd.concat([report.comparisons[:1].assign(range="both signs")] * 2)
    html = page_html(replace(report, comparisons=twice))
    said = "partly above 0; the cases of all comparisons are judged together, so the verdicts on single"
    rows = re.findall(r'<tr id="finding-(\d+)">(.*?)</tr>', html)
    assert [number for number, row in rows if said in row] == ["1"]


@needs_chromium
def test_search_finds_tables_figures_findings_and_settings(page, tmp_path):
    # This does not run in a frame, because its links would lead to the surrounding page.
    found, console = evaluate(
        page,
        tmp_path,
        STATE
        + """
        const input = document.querySelector(".search input");
        const press = (key, target) => target.dispatchEvent(
            new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
        press("/", document.body);
        const results = {focused: document.activeElement === input};
        for (const words of ["figure 7", "claim 12", "first-order", "smoothing", "short colour", "xyzzy"]) {
            type(input, words);
            results[words] = [...document.querySelectorAll(".found a")].map((one) => one.hash);
        }
        type(input, "table 26");
        press("Enter", input);
        await new Promise((done) => setTimeout(done, 50));
        return {...results, hash: location.hash, closed: document.querySelector(".found").hidden};
        """,
    )
    assert console == []
    assert found["focused"] and found["closed"] and found["hash"] == "#table-26"
    assert "#figure-7" in found["figure 7"]
    assert "#finding-12" in found["claim 12"]
    assert "#table-4" in found["first-order"]
    assert {"#section-4-5", "#setting-smoothing"} <= set(found["smoothing"])
    assert "#in-text-short" in found["short colour"]
    assert found["xyzzy"] == []


@needs_chromium
def test_the_theme_can_be_switched_and_is_remembered(page, tmp_path):
    script = """
    const dark = () => getComputedStyle(document.body).backgroundColor !== "rgb(255, 255, 255)";
    const before = dark();
    document.querySelector("button.theme").click();
    return [before, dark(), localStorage.getItem("placecat-theme")];
    """
    first, console = evaluate(page, tmp_path, script)
    second, _ = evaluate(page, tmp_path, script)
    assert console == []
    assert first == [False, True, "dark"]
    assert second == [True, False, "light"]


def test_every_table_figure_and_finding_has_a_link_to_itself(page):
    html = page.read_text(encoding="utf-8")
    anchors = re.findall(r'<(?:section class="table"|figure|tr) id="([^"]*)"', html)
    assert len(anchors) > 31 + 20 + 34
    assert [
        one for one in anchors if html.count(f'<a href="#{one}"') + html.count(f'"anchor" href="#{one}"') == 0
    ] == []
