import json
import zipfile

import numpy as np
import pytest
from made_system import frames, make_system

from placecat import __version__
from placecat.categorizer import Categorizer, model_file
from placecat.errors import PlacecatError


@pytest.fixture(scope="module")
def system():
    return make_system()


@pytest.fixture
def file(system, tmp_path):
    model_file.write(tmp_path / "model.placecat", system)
    return tmp_path / "model.placecat"


def test_a_system_comes_back_and_gives_the_same_bits(system, file):
    first, second = Categorizer(system), Categorizer.load(file)
    for frame in frames(4):
        one, two = first.update(frame), second.update(frame)
        np.testing.assert_array_equal(one.proba, two.proba)
        np.testing.assert_array_equal(one.integrated, two.integrated)
        assert one.place == two.place


def test_the_same_system_gives_the_same_bytes_and_nothing_is_pickled(system, file, tmp_path):
    model_file.write(tmp_path / "again.placecat", system)
    assert file.read_bytes() == (tmp_path / "again.placecat").read_bytes()
    with zipfile.ZipFile(file) as archive:
        for name in archive.namelist():
            content = archive.read(name)
            if name.endswith(".npy"):
                assert b"'O'" not in content[:128]
            else:
                content.decode("utf-8")
    assert len(list(tmp_path.iterdir())) == 2


def test_the_card_says_what_a_person_should_know(file):
    card = model_file.read(file).card
    assert card["classes"] == ["bedroom", "kitchen", "bathroom"]
    with zipfile.ZipFile(file) as archive:
        text = archive.read("card.md").decode()
    for part in (
        "bedroom, kitchen, bathroom",
        "320x180",
        "noise",
        "| 50.00 | 25.00 | 37.50 |",
        __version__,
        "numpy",
    ):
        assert part in text


def rewrite(file, name, change, compression=zipfile.ZIP_STORED):
    with zipfile.ZipFile(file) as archive:
        members = {member: archive.read(member) for member in archive.namelist()}
    members[name] = change(members[name])
    with zipfile.ZipFile(file, "w") as archive:
        for member, content in members.items():
            if content is not None:
                archive.writestr(member, content, compress_type=compression if member == name else None)


def change_json(**changes):
    return lambda content: json.dumps(json.loads(content) | changes).encode()


def object_array(_):
    import io

    buffer = io.BytesIO()
    np.save(buffer, np.array([print], dtype=object), allow_pickle=True)
    return buffer.getvalue()


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda file: file.unlink(), "placecat train"),
        (lambda file: file.write_bytes(b"no zip"), "no model"),
        (lambda file: file.write_bytes(file.read_bytes()[:5000]), "no model"),
        (lambda file: file.write_bytes(file.read_bytes().replace(b"\x93NUMPY", b"\x93NUMPX", 1)), "damaged"),
        (lambda file: rewrite(file, "card.json", change_json(format=99)), "format 99"),
        (lambda file: rewrite(file, "card.json", change_json(placecat="9.3.0")), "placecat 9.3.0"),
        (lambda file: rewrite(file, "card.json", lambda _: None), "card.json"),
        (lambda file: rewrite(file, "system.json", lambda _: b"{}"), "damaged"),
        (lambda file: rewrite(file, "system.json", lambda _: b"[1"), "damaged"),
        (lambda file: rewrite(file, "system.json", change_json(smoothing=[1])), "other kinds"),
        (lambda file: rewrite(file, "arrays/0000.npy", lambda _: None), "0000.npy"),
        (lambda file: rewrite(file, "arrays/0000.npy", object_array), "damaged"),
        (lambda file: rewrite(file, "arrays/0001.npy", lambda c: c, zipfile.ZIP_DEFLATED), "compressed"),
    ],
)
def test_what_is_no_model_of_this_version_is_refused(file, damage, message):
    damage(file)
    with pytest.raises(PlacecatError, match=message) as refused:
        model_file.read(file)
    assert str(file) in str(refused.value)


def test_other_classes_are_refused(file):
    Categorizer.load(file, classes=["bedroom", "kitchen", "bathroom"])
    with pytest.raises(PlacecatError, match="bedroom, kitchen, bathroom"):
        Categorizer.load(file, classes=["kitchen", "bedroom", "bathroom"])
