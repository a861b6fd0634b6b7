"""The files of data/thesis: references, and content that is rejected."""

import pytest

from placecat.errors import PlacecatError
from placecat.thesis import definitions

PARAMS = {"cues": {"gist": {"classifier": {"nu": 0.2}}}}
KNN = "defaults:\n- /clustering@tree: flat\n- _self_\nmodel: knn\nbase: {k: 1, smoothing: 1.0}\n"


@pytest.fixture
def write(tmp_path):
    def write(**texts):
        for name, text in texts.items():
            path = tmp_path / "data/thesis/tables" / f"{name.replace('__', '/')}.yaml"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return tmp_path

    for name, text in (("classifier/knn", KNN), ("clustering/flat", "size: 4\n")):
        path = tmp_path / f"conf/{name}.yaml"
        path.parent.mkdir(parents=True)
        path.write_text(text)
    return write


def test_a_table_can_start_from_a_conf_file_or_another_table(write):
    knn = "{classifier: {like: conf/classifier/knn.yaml, base: {k: 3}}}"
    first = f"number: 1\ntitle: A\ntrial: {knn}\nhomes: all\naxes: {{}}\n"
    second = "like: data/thesis/tables/study/table_01.yaml\nnumber: 2\ntrial: {classifier: {base: {k: 5}}}\n"
    flat = "{classifier: {like: conf/clustering/flat.yaml}}"
    third = f"like: data/thesis/tables/study/table_01.yaml\ntrial: {flat}\n"
    root = write(study__table_01=first, study__table_02=second, study__table_03=third)
    found = definitions.studies(PARAMS, root)["study"]
    knn = {"tree": {"size": 4}, "model": "knn", "base": {"k": 3, "smoothing": 1.0}}
    assert found["table_01"]["trial"] == {"classifier": knn}
    assert found["table_02"]["trial"]["classifier"]["base"] == {"k": 5, "smoothing": 1.0}
    assert (found["table_02"]["number"], found["table_02"]["title"]) == (2, "A")
    # A classifier that starts from a file inherits nothing from the other table.
    assert found["table_03"]["trial"]["classifier"] == {"size": 4}


def test_references_to_settings_are_resolved(write):
    root = write(study__table_01="trial: {classifier: '${cues.gist.classifier}'}\nhomes: all\naxes: {}\n")
    found = definitions.studies(PARAMS, root)["study"]["table_01"]
    assert found["trial"] == {"classifier": {"nu": 0.2}}


def test_a_table_that_needs_a_setting_is_included_only_with_it(write):
    root = write(table_01="number: 1\n", table_02="number: 2\nneeds: cues.embedding\n")
    assert list(definitions.tables(PARAMS, root)) == ["table_01"]
    assert definitions.optional(root) == ["table_02"]
    extended = {"cues": PARAMS["cues"] | {"embedding": {}}}
    assert list(definitions.tables(extended, root)) == ["table_01", "table_02"]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        (
            "table_01",
            "titel: A\n",
            r"data/thesis/tables/table_01\.yaml has no setting 'titel'; did you mean 'title'",
        ),
        ("table_01", "trial: {}\n", r"table_01\.yaml has no setting 'trial'"),
        ("s__table_01", "rows: []\n", r"tables/s/table_01\.yaml has no setting 'rows'"),
        ("table_01", "title: ${cues.gits}\n", r"table_01\.yaml: setting 'cues\.gits' does not exist"),
        ("table_01", "like: conf/nothing.yaml\n", r"conf/nothing\.yaml is missing"),
        ("table_01", "like: data/thesis/tables/table_01.yaml\n", r"table_01\.yaml refers to itself"),
        ("table_01", "title: {\n", r"table_01\.yaml is not valid YAML"),
        ("table_01", "", r"table_01\.yaml is empty"),
    ],
)
def test_a_mistake_names_its_file_in_one_line(write, name, text, message):
    root = write(**{name: text})
    with pytest.raises(PlacecatError, match=message) as caught:
        definitions.tables(PARAMS, root)
        definitions.studies(PARAMS, root)
    assert "\n" not in str(caught.value)
