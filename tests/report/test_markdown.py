import numpy as np

from made_report import DATASET, addition, captioned, cells, settings
from placecat.report.formats import _MARKDOWN, table_markdown


def lines_of(text):
    return [line for line in text.splitlines() if line.startswith("|")]


def test_the_published_numbers_follow_the_measured_numbers():
    table = cells(12, np.random.default_rng(0))
    text = table_markdown(settings(12, "KNN"), table, DATASET | {"homes": ["a", *"bcde", "f"]})
    assert text.startswith(
        "# Table 12: KNN\n\nPercent, measured on made-up homes. Home 1 is a, Home 6 is f. "
    )
    measured, published = text.split("## Published")
    for part, column in ((measured, "measured"), (published, "published")):
        numbers = [cell.strip() for line in lines_of(part) for cell in line.split("|")[2:-1]]
        expected = [f"{value:.2f}" for value in table[column]]
        assert [one for one in numbers if "." in one] == expected
        assert "**HOG + y-Pos**" in part
    assert "They are not comparable, since the data differ." in published


def test_rows_have_as_many_cells_as_the_head():
    lines = lines_of(table_markdown(settings(26), cells(26), DATASET))
    assert {line.count("|") for line in lines} == {9}
    assert lines[1] == "|---|" + "---:|" * 7


def test_an_addition_has_no_number_and_no_published_numbers():
    one = addition()
    text = table_markdown(one.settings, one.cells, DATASET)
    assert text.startswith("# RVM beside SVM\n")
    assert "Published" not in text
    assert "| SVM | 33.00 | <sup>a</sup> |" in text
    assert text.endswith("a: too few frames.\n\n")


def test_a_table_that_is_not_in_percent_explains_its_numbers():
    one = captioned()
    text = table_markdown(one.settings, one.cells, DATASET)
    start = "# How good\n\nLog loss in nats, stay accuracy in percent. Measured on made-up homes.\n"
    assert text.startswith(start)
    assert "Percent, " not in text and "points" not in text
    assert "| Gist | 1.61 | 40.00 |" in text


def test_numbers_on_the_same_data_are_comparable():
    text = table_markdown(settings(5), cells(5), DATASET | {"thesis_data": "VPC-2009 home database"})
    assert "The thesis's numbers on the same data." in text


def test_markup_in_names_is_escaped():
    table = cells(5)
    table["row"] = table["row"].replace("SVM", "a|b *c*")
    assert r"| a\|b \*c\* | 37.22 |" in table_markdown(settings(5), table, DATASET)
    assert "a|b*c`d<e>\nf".translate(_MARKDOWN) == r"a\|b\*c\`d\<e> f"
