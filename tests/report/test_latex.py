import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from made_report import DATASET, addition, cells, settings
from placecat.report.formats import _LATEX, table_latex

ESCAPED = {
    r"\textbackslash{}": "\\",
    r"\textasciitilde{}": "~",
    r"\textasciicircum{}": "^",
    r"\textless{}": "<",
    r"\textgreater{}": ">",
    r"\textbar{}": "|",
    r"\textquotedbl{}": '"',
    "{[}": "[",
    **{f"\\{character}": character for character in "&%$#_{}"},
}


def unescape(text):
    tokens = "|".join(map(re.escape, sorted(ESCAPED, key=len, reverse=True)))
    return re.sub(f"{tokens}|.", lambda match: ESCAPED.get(match[0], match[0]), text, flags=re.DOTALL)


def without_escapes(text):
    return re.sub(r"\\[&%$#_{}\\]", "", text)


@given(st.text(st.characters(codec="ascii", exclude_characters="\n")))
def test_escaping_is_reversible_and_leaves_no_special_characters(text):
    escaped = text.translate(_LATEX)
    assert unescape(escaped) == text
    bare = without_escapes(escaped)
    assert not re.search(r"[&%$#_~^|<>]", bare)
    assert bare.count("{") == bare.count("}")


def check_structure(text):
    """Check that braces and environments close in order and that every row has a cell for each column."""
    bare = without_escapes(text)
    depth = 0
    for character in bare:
        depth += (character == "{") - (character == "}")
        assert depth >= 0
    assert depth == 0
    opened = []
    for kind, name in re.findall(r"\\(begin|end)\{(\w+)\}", text):
        if kind == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert opened == []
    columns = int(re.search(r"\\begin\{tabular\}\{l\*\{(\d+)\}\{r\}\}", text)[1])
    body = text[text.index(r"\toprule") : text.index(r"\bottomrule")]
    rows = [line for line in body.splitlines() if line.endswith(r" \\")]
    for row in rows:
        if row.startswith(r"\multicolumn"):
            assert row.startswith(rf"\multicolumn{{{columns + 1}}}{{l}}")
        else:
            assert len(re.findall(r"(?<!\\)&", row)) == columns
    return rows


@pytest.mark.parametrize("number", range(1, 32))
def test_every_table_is_well_formed_and_complete(number):
    table = cells(number, np.random.default_rng(number))
    text = table_latex(settings(number), table, DATASET)
    rows = check_structure(text)
    numbers = [
        one for row in rows[1:] for one in re.split(r"(?<!\\) & ", row.removesuffix(r" \\"))[1:] if one
    ]
    italic = [one for one in numbers if one.startswith(r"\textit")]
    assert [one for one in numbers if one not in italic] == [f"{value:.2f}" for value in table["measured"]]
    known = ["n/a" if np.isnan(value) else f"{value:.2f}" for value in table["published"]]
    assert italic == [rf"\textit{{{one}}}" for one in known]
    assert rf"\label{{tab:table-{number:02d}}}" in text


def test_the_published_row_follows_the_measured_row():
    table = cells(5, np.random.default_rng(0))
    _, *rows = check_structure(table_latex(settings(5), table, DATASET))
    first = table[table["row"] == "naive Bayes"]
    assert rows[0] == f"naive Bayes & {' & '.join(f'{value:.2f}' for value in first['measured'])} \\\\"
    assert rows[1] == " & " + " & ".join(f"\\textit{{{value:.2f}}}" for value in first["published"]) + r" \\"


def test_names_and_titles_are_escaped():
    table = cells(5)
    table["row"] = table["row"].replace("SVM", "[100 %] R&D_1 {x} C:\\")
    text = table_latex(settings(5, "50 % & more_"), table, DATASET | {"title": "my_homes #1"})
    check_structure(text)
    assert r"\caption{50 \% \& more\_." in text
    assert r"measured on my\_homes \#1." in text
    assert r"{[}100 \%] R\&D\_1 \{x\} C:\textbackslash{} & " in text


def test_empty_cells_have_a_footnote_with_the_reason():
    one = addition()
    text = table_latex(one.settings, one.cells, DATASET)
    assert r"SVM & 33.00 & \textsuperscript{a} \\" in check_structure(text)
    assert r"\textsuperscript{a} too few frames." in text
    assert r"\textit" not in text
    assert r"\label{tab:rvm}" in text


def test_the_caption_names_the_data_of_the_published_numbers():
    other = table_latex(settings(5), cells(5), DATASET)
    assert "on the VPC-2009 home database, so they are not comparable." in other
    same = table_latex(settings(5), cells(5), DATASET | {"thesis_data": "VPC-2009 home database"})
    assert "Published numbers are in italics, on the same data." in same
