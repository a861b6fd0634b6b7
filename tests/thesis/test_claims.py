import pytest

from placecat.errors import PlacecatError
from placecat.thesis.claims import Side, read_finding

LEFT, RIGHT = {"label": "left", "result": "a"}, {"label": "right", "results": ["b", "c"], "combine": "best"}


def finding(*comparisons, **more):
    return {"number": 3, "section": "4.2", "claim": "A is better.", "comparisons": list(comparisons)} | more


def comparison(**changes):
    return {"left": LEFT, "right": RIGHT, "range": "better"} | changes


def test_a_finding_is_read():
    read = read_finding("finding_03", finding(comparison()))
    assert (read.name, read.number, read.section, read.claim) == ("finding_03", 3, "4.2", "A is better.")
    (one,) = read.comparisons
    assert one.left == Side("left", ("a",))
    assert one.right == Side("right", ("b", "c"), combine="best")
    assert one.range == ("better", None)
    assert one.compare == "difference"


def test_each_stands_for_several_comparisons():
    template = comparison(
        each=[{"name": "HOG", "table": 23}, {"name": "SIFT", "table": 24}],
        left={"label": "{name}", "result": "cues/{name}", "published": {"table": "{table}", "row": "{name}"}},
        range={"within": 2},
    )
    first, second = read_finding("f", finding(template)).comparisons
    assert (first.left.label, first.left.results) == ("HOG", ("cues/HOG",))
    assert second.left.published == ({"table": "24", "row": "SIFT"},)
    assert first.right == second.right
    assert first.range == ("within", 2.0)


def test_without_a_right_side_the_left_is_compared_with_a_number():
    (one,) = read_finding("f", finding({"left": LEFT, "range": {"above": 99}})).comparisons
    assert one.right is None
    assert one.sides == (one.left,)


@pytest.mark.parametrize(
    ("config", "message"),
    [
        (finding(comparison(rang="better")), "no setting 'rang'; did you mean 'range'"),
        (finding(comparison(left={"label": "x", "result": "a", "plce": "b"})), "did you mean 'place'"),
        (finding(comparison(left={"label": "x"})), "either result or results"),
        (finding(comparison(left=LEFT | {"results": ["a"]})), "either result or results"),
        (finding(comparison(right=RIGHT | {"combine": "worst"})), "use one of mean, best, last"),
        (
            finding(comparison(right=RIGHT | {"published": [{"text": "x"}]})),
            "1 published numbers for 2 results",
        ),
        (finding(comparison(range={"within": 1, "above": 2})), "has 2 kinds"),
        (finding(comparison(range="both_signs")), "as many results"),
        (finding(comparison(compare="product")), "use difference or ratio"),
        (
            finding({"left": LEFT, "range": {"above": 9}, "compare": "ratio"}),
            "a ratio in .* needs a right side",
        ),
        (finding({"left": LEFT, "range": "better"}), "a right side or the range 'above', but not both"),
        (finding(comparison(range={"above": 9})), "a right side or the range 'above', but not both"),
        (finding({"left": LEFT}), "missing a required argument: 'range'"),
        (finding(), "contains no comparisons"),
        (finding(comparison(), title="x"), "no setting 'title'"),
    ],
)
def test_invalid_settings_are_rejected(config, message):
    with pytest.raises(PlacecatError, match=message):
        read_finding("finding_03", config)
