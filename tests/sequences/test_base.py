from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from helpers_sequences import HEIGHT, WIDTH, coded, decoded, write_image, write_video

from placecat import lookup
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.footage.names import natural
from placecat.sequences import open_home
from placecat.sequences.base import Home, frame_table
from placecat.sequences.folders import inside
from placecat.sequences.places import place_labels, require_classes

LAYOUTS = lookup.names("placecat.sequences", "read_home")
CLASSES = ["bedroom", "bathroom", "kitchen", "living_room"]


def rows(sources: list[str], positions: list[int]) -> pd.DataFrame:
    return pd.DataFrame({"source": sources, "position": positions})


def make_home(labels: list[str]) -> Home:
    return Home(
        name="Home7",
        root=Path("data"),
        fps=5.0,
        camera="",
        width=8,
        height=8,
        frames=frame_table(
            "2",
            [f"{i}.jpg" for i in range(len(labels))],
            -1,
            range(1, len(labels) + 1),
            np.zeros(len(labels)),
            labels,
        ),
        label_files={"2": "Home7/label.txt"},
        label_lines=np.arange(10, 10 + len(labels), dtype=np.int32),
    )


class TestOpenHome:
    def test_layouts_are_the_reader_modules(self) -> None:
        assert LAYOUTS == ["bags", "cold", "folder", "robot_at_home", "video", "vpc2009"]

    @pytest.mark.parametrize("layout", ["tum", "labels", "base", "../folder", "", "os"])
    def test_unknown_layout(self, layout: str, tmp_path: Path) -> None:
        with pytest.raises(
            PlacecatError,
            match=r"dataset.layout .* does not exist.*: use one of bags, .*, robot_at_home, video, vpc2009$",
        ):
            open_home(layout, tmp_path, "Home1")

    @pytest.mark.parametrize("layout", LAYOUTS)
    def test_missing_root(self, layout: str, tmp_path: Path) -> None:
        with pytest.raises(PlacecatError, match=r"nowhere does not exist; set dataset.root"):
            open_home(layout, tmp_path / "nowhere", "Home1", fps=5.0)

    @pytest.mark.parametrize("layout", LAYOUTS)
    def test_root_is_a_file(self, layout: str, tmp_path: Path) -> None:
        (tmp_path / "file").write_text("x")
        with pytest.raises(PlacecatError, match=r"file is not a folder; set dataset.root"):
            open_home(layout, tmp_path / "file", "Home1", fps=5.0)

    @pytest.mark.parametrize("layout", LAYOUTS)
    @pytest.mark.parametrize("name", ["../Home1", "/etc", "a/../../b", "", "."])
    def test_name_leads_out_of_the_root(self, layout: str, name: str, tmp_path: Path) -> None:
        with pytest.raises(PlacecatError, match=r"dataset.homes: .*is not a path below the data folder"):
            open_home(layout, tmp_path, name, fps=5.0)


class TestReadFrames:
    def test_images_in_the_order_of_the_rows(self, tmp_path: Path) -> None:
        for number in range(4):
            write_image(tmp_path / f"home/{number}.png", number)
        images = list(read_frames(tmp_path, rows(["home/3.png", "home/0.png", "home/2.png"], [-1] * 3)))
        assert [decoded(image) for image in images] == [3, 0, 2]
        assert images[0].dtype == np.uint8
        np.testing.assert_array_equal(images[0], coded(3))

    @pytest.mark.parametrize("codec", ["MJPG", "mp4v"])
    def test_video_frames_are_exact(self, codec: str, tmp_path: Path) -> None:
        write_video(tmp_path / "a.avi", 200, codec=codec)
        wanted = [0, 1, 5, 5, 130, 199, 3, 4, 57, 56, 12]
        assert [decoded(f) for f in read_frames(tmp_path, rows(["a.avi"] * len(wanted), wanted))] == wanted

    def test_two_videos_and_an_image(self, tmp_path: Path) -> None:
        write_video(tmp_path / "a.avi", 9)
        write_video(tmp_path / "b.avi", 9)
        write_image(tmp_path / "c.png", 77)
        images = read_frames(tmp_path, rows(["a.avi", "b.avi", "c.png", "b.avi", "a.avi"], [2, 8, -1, 3, 1]))
        assert [decoded(image) for image in images] == [2, 8, 77, 3, 1]

    def test_rotated_pictures_and_videos(self, tmp_path: Path) -> None:
        write_video(tmp_path / "a.avi", 9)
        write_image(tmp_path / "c.png", 77, width=HEIGHT, height=WIDTH)
        mixed = rows(["a.avi", "c.png", "a.avi"], [5, -1, 6]).assign(turn=[90, 0, 270])
        images = list(read_frames(tmp_path, mixed, size=(HEIGHT, WIDTH)))
        # NumPy rotates counter-clockwise.
        back = [np.rot90(image, turn // 90) for image, turn in zip(images, mixed["turn"], strict=True)]
        assert [decoded(np.ascontiguousarray(image)) for image in back] == [5, 77, 6]
        with pytest.raises(PlacecatError, match=r"a\.avi frame 6: the frame is 64x48, but .* 48x64"):
            list(read_frames(tmp_path, mixed.assign(turn=0), size=(HEIGHT, WIDTH)))
        with pytest.raises(PlacecatError, match="cannot be rotated by 45 degrees; choose 0, 90, 180 or 270"):
            list(read_frames(tmp_path, mixed.assign(turn=45)))

    def test_numbered_images_are_not_read_as_a_video(self, tmp_path: Path) -> None:
        # OpenCV's image backend would read 00000001.png, 00000002.png, ... as one video.
        for number in (1, 2):
            write_image(tmp_path / f"{number:08d}.png", number)
        with pytest.raises(PlacecatError, match=r"00000001\.png: not a readable video"):
            list(read_frames(tmp_path, rows(["00000001.png"], [1])))

    def test_video_too_short(self, tmp_path: Path) -> None:
        write_video(tmp_path / "a.avi", 9)
        with pytest.raises(
            PlacecatError, match=r"a\.avi: frame 10 is missing or unreadable \(the file ends after 9\)"
        ):
            list(read_frames(tmp_path, rows(["a.avi"] * 2, [8, 9])))

    def test_missing_image(self, tmp_path: Path) -> None:
        with pytest.raises(PlacecatError, match=r"home/1\.png: the frame is missing; restore it"):
            list(read_frames(tmp_path, rows(["home/1.png"], [-1])))

    def test_image_is_a_folder(self, tmp_path: Path) -> None:
        (tmp_path / "1.png").mkdir()
        with pytest.raises(PlacecatError, match=r"1\.png: the frame cannot be opened"):
            list(read_frames(tmp_path, rows(["1.png"], [-1])))

    def test_wrong_size(self, tmp_path: Path) -> None:
        write_image(tmp_path / "1.png", 1)
        write_image(tmp_path / "2.png", 2, width=72, height=40)
        with pytest.raises(
            PlacecatError, match=r"2\.png: the frame is 72x40, but the other frames of this home are 64x48"
        ):
            list(read_frames(tmp_path, rows(["1.png", "2.png"], [-1, -1])))
        with pytest.raises(
            PlacecatError, match=r"1\.png: the frame is 64x48, but the other frames of this home are 72x40"
        ):
            next(read_frames(tmp_path, rows(["1.png"], [-1]), size=(72, 40)))

    def test_message_names_the_video_frame_with_the_wrong_size(self, tmp_path: Path) -> None:
        write_video(tmp_path / "a.avi", 3)
        with pytest.raises(PlacecatError, match=rf"a\.avi frame 3: the frame is {WIDTH}x{HEIGHT}"):
            list(read_frames(tmp_path, rows(["a.avi"], [2]), size=(8, 8)))

    @pytest.mark.parametrize(
        "source", ["../secret.png", "/secret.png", "a/../../secret.png", "", "..\\secret.png"]
    )
    def test_paths_stay_below_the_root(self, source: str, tmp_path: Path) -> None:
        write_image(tmp_path / "secret.png", 1)
        (tmp_path / "root").mkdir()
        with pytest.raises(PlacecatError, match=r"frame list: .* is not a path below the data folder"):
            list(read_frames(tmp_path / "root", rows([source], [-1])))


class TestPlaceLabels:
    def test_literal(self) -> None:
        labels = pd.Series(["kitchen", "transition", "2PO", "", "bedroom", "bath", "kitchen"])
        found = place_labels(labels, CLASSES, ["transition"], {"2PO": "living_room", "bath": "bathroom"})
        np.testing.assert_array_equal(found, np.array([2, -1, 3, -1, 0, 1, 2], dtype=np.int16))
        assert found.dtype == np.int16

    def test_alias_of_an_ignored_label_and_of_a_class(self) -> None:
        found = place_labels(
            pd.Series(["CR", "kitchen"]), CLASSES, ["corridor"], {"CR": "corridor", "kitchen": "bedroom"}
        )
        assert found.tolist() == [-1, 0]

    def test_missing_values_are_unlabelled(self) -> None:
        labels = pd.Series(["kitchen", None, float("nan")], dtype=object)
        assert place_labels(labels, CLASSES, [], {}).tolist() == [2, -1, -1]

    def test_no_labels(self) -> None:
        assert place_labels(pd.Series([], dtype=str), CLASSES, [], {}).shape == (0,)

    def test_message_locates_an_unknown_label(self) -> None:
        home = make_home(["kitchen", "kitchen", "bedrom", "office"])
        with pytest.raises(PlacecatError) as caught:
            place_labels(home.frames["label"], CLASSES, ["transition"], {}, home=home)
        assert str(caught.value) == (
            "Home7, sequence 2, frame 3 (data/Home7/label.txt line 12): unknown label 'bedrom' (did you mean "
            "'bedroom'?); correct it, add it to dataset.ignored to leave such frames unlabelled, or "
            "add it to dataset.aliases if it is another name for a class."
        )

    def test_unknown_label_in_selected_rows(self) -> None:
        home = make_home(["kitchen", "hall", "kitchen", "zzz"])
        with pytest.raises(PlacecatError, match=r"frame 4 \(.* line 13\): unknown label 'zzz'; correct"):
            place_labels(home.frames["label"][[0, 3]], CLASSES, [], {}, home=home)

    @pytest.mark.parametrize(
        ("wrong", "right"),
        [
            ("Kitchen", "kitchen"),
            ("living room", "living_room"),
            ("transitoin", "transition"),
            ("2P0", "2PO"),
        ],
    )
    def test_nearest_spelling(self, wrong: str, right: str) -> None:
        with pytest.raises(PlacecatError, match=f"unknown label '{wrong}' .did you mean '{right}'"):
            place_labels(pd.Series([wrong]), CLASSES, ["transition"], {"2PO": "kitchen"})

    def test_invalid_settings(self) -> None:
        labels = pd.Series(["kitchen"])
        with pytest.raises(PlacecatError, match=r"dataset.classes is empty"):
            place_labels(labels, [], [], {})
        with pytest.raises(
            PlacecatError, match=r"dataset.aliases: 'KT' stands for 'kitchn'.*did you mean 'kitchen'"
        ):
            place_labels(labels, CLASSES, [], {"KT": "kitchn"})


def test_require_classes() -> None:
    require_classes(np.array([0, 2, -1, 1], dtype=np.int16), ["a", "b", "c"], "Home1")
    with pytest.raises(
        PlacecatError,
        match=r"Home1: no frame is labelled b or c; label some, .*dataset\.require_all_classes=false",
    ):
        require_classes(np.array([0, -1], dtype=np.int16), ["a", "b", "c"], "Home1")


def test_natural_order() -> None:
    names = ["f10.jpg", "f2.jpg", "F1.jpg", "f02.jpg", "10", "9", "a"]
    assert sorted(names, key=natural) == ["9", "10", "a", "F1.jpg", "f02.jpg", "f2.jpg", "f10.jpg"]


def test_inside_follows_links(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "other").mkdir()
    (tmp_path / "data/link").symlink_to(tmp_path / "other")
    inside(tmp_path / "data", tmp_path, "list")
    with pytest.raises(PlacecatError, match=r"list: .*link is a link that points outside"):
        inside(tmp_path / "data/link", tmp_path / "data", "list")


def test_home_checks_its_columns() -> None:
    home = make_home(["kitchen"])
    with pytest.raises(TypeError, match="columns"):
        Home("a", Path(), 1.0, "", 1, 1, home.frames.drop(columns="label"), {}, home.label_lines)
    with pytest.raises(TypeError, match="columns"):
        Home("a", Path(), 1.0, "", 1, 1, home.frames.assign(tilt=1), {}, home.label_lines)
    assert "turn" not in home.frames
    Home("a", Path(), 1.0, "", 1, 1, home.frames.assign(turn=90), {}, home.label_lines)
    with pytest.raises(TypeError, match="label lines"):
        Home("a", Path(), 1.0, "", 1, 1, home.frames, {}, home.label_lines[:0])
