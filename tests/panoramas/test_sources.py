"""Tests of the panoramas in a source, and of mistakes in its files."""

import json
import re
import shlex
import shutil

import numpy as np
import pytest
from worlds import settings, write

from placecat.errors import PlacecatError
from placecat.panoramas import sources

PICTURE = np.zeros((4, 8, 3), dtype=np.uint8)
TABLE = "home,floor,file,room\nflat,1,a.jpg,Living Room\nflat,2,b/c.jpg,bedroom 2\n,,,\nvilla,1,d.jpg,hall\n"


@pytest.fixture
def table(tmp_path):
    """Create a source with a table, and return a function that rewrites the table and reads the source."""
    for name in ("a.jpg", "b/c.jpg", "d.jpg", "e.jpg"):
        write(tmp_path / name, PICTURE)

    def read(text=TABLE, *changes):
        (tmp_path / "rooms.csv").write_text(text)
        return sources.read(tmp_path, settings(*changes))

    return read


def test_a_table_names_home_floor_room_and_label(table, tmp_path):
    found = [(one.home, one.floor, one.room, one.label, one.files) for one in table()]
    assert found == [
        ("flat", "1", "living_room", "living_room", ("a.jpg",)),
        ("flat", "2", "bedroom_2", "bedroom", ("b/c.jpg",)),
        ("villa", "1", "hall", "corridor", ("d.jpg",)),
    ]
    assert table()[2].origin == f"{tmp_path / 'rooms.csv'} line 5"
    assert [one.home for one in table(TABLE, "homes=[villa]")] == ["villa"]
    short = table("room,home,file\nmy den,flat,a.jpg\n", "labels.workspace=[my den]")
    assert [(one.floor, one.label) for one in short] == [("1", "workspace")]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "home,floor",
            "house,floor",
            "rooms.csv line 1: the header is 'house,floor,file,room'; write home,file,room",
        ),
        ("file,room", "file,file", "rooms.csv line 1: the header is"),
        ("2,b/c.jpg", "b/c.jpg", "rooms.csv line 3 has 3 columns; expected home,floor,file,room"),
        ("2,b/c.jpg", "2,", "rooms.csv line 3: file is empty"),
        ("flat,2", "flat,up/..", "rooms.csv line 3: 'up/..' is not a valid floor"),
        ("flat,2", "../flat,2", "rooms.csv line 3: home=../flat: it names a file or folder"),
        ("flat,2", "FLAT,2", "line 3: the home names 'flat' and 'FLAT' differ only in case"),
        (
            "bedroom 2",
            "bedrom 2",
            "rooms.csv line 3: unknown room 'bedrom 2'; did you mean 'bedroom'? Correct it, or add",
        ),
        ("b/c.jpg", "b/x.jpg", "b/x.jpg: the image is missing (.*rooms.csv line 3)"),
        ("b/c.jpg", "../c.jpg", "rooms.csv line 3: '../c.jpg' is not a path below"),
        ("b/c.jpg", "a.jpg", "rooms.csv line 3: a.jpg is already listed (.*rooms.csv line 2)"),
        ("b/c.jpg", "x" * 300, "cannot be read (File name too long)"),
        ("hall", '"hall', "rooms.csv line 5: a quotation mark is not closed"),
    ],
)
def test_a_mistake_in_the_table_is_named_with_its_line(table, old, new, message):
    assert old in TABLE
    pattern = re.escape(message).replace(r"\.\*", ".*")
    with pytest.raises(PlacecatError, match=pattern) as caught:
        table(TABLE.replace(old, new))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("room", ["Ballroom 2", "my good, room", "o'hara's"])
@pytest.mark.parametrize("changes", [[], ["labels.living_room=[walk-in salon,lounge]"]])
def test_the_override_that_a_refused_room_names_adds_it(table, room, changes):
    text = TABLE.replace("bedroom 2", f'"{room}"')
    with pytest.raises(PlacecatError, match="unknown room") as caught:
        table(text, *changes)
    (override,) = shlex.split(str(caught.value).partition("for example ")[2])
    found = table(text + "flat,1,e.jpg,lounge\n" if changes else text, override)
    assert found[1].label == "living_room"


def test_a_source_without_its_folder_or_table_is_refused(table, tmp_path):
    with pytest.raises(PlacecatError, match="nowhere does not exist; specify the folder with the panoramas"):
        sources.read(tmp_path / "nowhere", settings())
    with pytest.raises(PlacecatError, match=r"rooms\.csv: the table of rooms is missing"):
        sources.read(tmp_path, settings())
    with pytest.raises(PlacecatError, match="contains no panoramas"):
        table("home,file,room\n")
    with pytest.raises(PlacecatError, match="homes: there is no home 'vila'; did you mean 'villa'"):
        table(TABLE, "homes=[vila]")
    with pytest.raises(PlacecatError, match="source 'zint' does not exist; did you mean 'zind'"):
        table(TABLE, "source=zint")


def test_a_link_that_leads_out_is_refused(table, tmp_path):
    (tmp_path / "a.jpg").unlink()
    (tmp_path / "a.jpg").symlink_to("/etc/hostname")
    with pytest.raises(PlacecatError, match=r"rooms\.csv line 2: .*a\.jpg is a link that points outside"):
        table()


def test_a_cube_has_six_pictures_named_by_settings(tmp_path):
    (tmp_path / "rooms.csv").write_text("home,file,room\nflat,FACE,kitchen\n")
    for letter in "frblud":
        write(tmp_path / f"FACE_{letter}.jpg", PICTURE)
    (only,) = sources.read(tmp_path, settings("source=cubes"))
    assert only.files == tuple(f"FACE_{letter}.jpg" for letter in "frblud")
    changes = ["source=cubes", "cubes.file=tiles/FACE/FILE.jpg", "cubes.faces.up=top"]
    with pytest.raises(
        PlacecatError, match=r"tiles/f/FACE\.jpg: the image is missing .*cubes\.file=tiles/FACE/FILE\.jpg"
    ):
        sources.read(tmp_path, settings(*changes))
    for folder in ("f", "r", "b", "l", "top", "d"):
        write(tmp_path / f"tiles/{folder}/FACE.jpg", PICTURE)
    (only,) = sources.read(tmp_path, settings(*changes))
    assert only.files[4] == "tiles/top/FACE.jpg"


def panorama(number, label, **more):
    return {"label": label, "image_path": f"panos/{number}.jpg", "floor_number": 1, "is_inside": True} | more


ZIND = {
    "scale_meters_per_coordinate": {"floor_01": 1.2},
    "merger": {
        "floor_01": {
            "complete_room_01": {
                "partial_room_01": {"pano_1": panorama(1, "kitchen"), "pano_2": panorama(2, "kitchen")},
                "partial_room_02": {"pano_3": panorama(3, "dining room")},
            },
            "complete_room_02": {"partial_room_03": {"pano_4": panorama(4, "garage")}},
        },
        "floor_02": {
            "complete_room_03": {
                "partial_room_04": {
                    "pano_5": panorama(5, "master bedroom"),
                    "pano_6": panorama(6, "bedroom", is_inside=False),
                }
            }
        },
    },
    "redraw": {},
}


@pytest.fixture
def zind(tmp_path):
    """Create a home in the Zillow Indoor Dataset format, and return a function that rewrites and reads it."""
    for number in range(1, 7):
        write(tmp_path / f"007/panos/{number}.jpg", PICTURE)
    (tmp_path / "notes").mkdir()

    def read(content=ZIND, *changes):
        text = content if isinstance(content, str) else json.dumps(content)
        (tmp_path / "007/zind_data.json").write_text(text)
        return sources.read(tmp_path, settings("source=zind", *changes))

    return read


def test_zind_gives_floors_rooms_and_labels(zind):
    found = [(one.floor, one.room, one.label, one.files[0]) for one in zind()]
    assert found == [
        ("floor_01", "complete_room_01_kitchen", "kitchen", "007/panos/1.jpg"),
        ("floor_01", "complete_room_01_kitchen", "kitchen", "007/panos/2.jpg"),
        ("floor_01", "complete_room_01_dining_room", "dining_room", "007/panos/3.jpg"),
        ("floor_01", "complete_room_02_transition", "transition", "007/panos/4.jpg"),
        ("floor_02", "complete_room_03_bedroom", "bedroom", "007/panos/5.jpg"),
    ]
    assert {one.home for one in zind()} == {"zind_007"}
    assert len(zind(ZIND, "zind.inside_only=false")) == 6
    assert [one.label for one in zind(ZIND, "zind.others=null")].count("transition") == 0


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"merger"', '"merged"', "zind_data.json: merger has no floor"),
        (
            '{"pano_4"',
            '7, "x": {"pano_4"',
            "merger.floor_01.complete_room_02.partial_room_03 has no panorama",
        ),
        ('"pano_4": {', '"pano_7": [], "pano_4": {', "partial_room_03.pano_7 is not a panorama"),
        ('"label": "garage"', '"label": 7', "partial_room_03.pano_4: label and image_path must be text"),
        ("panos/4.jpg", "panos/9.jpg", "007/panos/9.jpg: the image is missing"),
        ("panos/4.jpg", "../../secret.jpg", "'../../secret.jpg' is not a path below"),
        ('"floor_02"', '"../floor"', "'../floor' is not a valid floor name"),
        ("}, ", "}, \n,", "zind_data.json line 2 is not valid JSON"),
    ],
)
def test_a_mistake_in_zind_is_named(zind, old, new, message):
    text = json.dumps(ZIND)
    assert old in text
    with pytest.raises(PlacecatError, match=re.escape(message)) as caught:
        zind(text.replace(old, new, 1))
    assert "\n" not in str(caught.value)


def test_odd_zind_is_refused(zind, tmp_path):
    with pytest.raises(PlacecatError, match=r"zind_data\.json is not valid JSON \(RecursionError\)"):
        zind("[" * 100_000)
    shutil.rmtree(tmp_path / "007")
    with pytest.raises(PlacecatError, match=r"contains no homes; expected HOME/zind_data\.json"):
        sources.read(tmp_path, settings("source=zind"))
