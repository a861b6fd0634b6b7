import shutil
from fractions import Fraction

import av
import cv2
import numpy as np
import pytest
from clips import copied, flip, intact, packets, shown, steady, turned_on_the_way, write_clip, zero
from helpers_sequences import HEIGHT, WIDTH, decoded, write_video

from placecat.errors import PlacecatError
from placecat.footage.recording import Recording

MILLI = Fraction(1, 1000)
# One key frame, followed by frames that each refer to the previous one.
CHAIN = {"g": "1000", "bf": "0", "preset": "ultrafast"}


def by_opencv(path):
    capture, found = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG), []
    while (read := capture.read())[0]:
        found.append(read[1])
    return found


@pytest.mark.parametrize("number", [41, 96])
@pytest.mark.parametrize("start", [0, 5])
def test_a_damaged_packet_costs_one_frame_and_the_others_keep_their_numbers(number, start, tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(100), options=CHAIN)
    zero(path, number, start)
    recording = Recording(path)
    numbers = [one for one, _ in shown(recording)]
    assert numbers == [one for one in range(1, 101) if one != number]
    assert recording.lost == [number]
    assert np.allclose(recording.timing().seconds, steady(100))
    assert f"a.mp4: frame {number} of 100 cannot be decoded and is lost" in recording.note()


def test_frames_of_one_damaged_picture_are_the_same_every_time(tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(60))
    zero(path, 25)
    flip(path, 40)
    first = Recording(path)
    expected = [(picture.number, picture.image().tobytes()) for picture in first.pictures()]
    for _ in range(5):
        again = Recording(path)
        assert [(picture.number, picture.image().tobytes()) for picture in again.pictures()] == expected
        assert again.note() == first.note() != ""


@pytest.mark.parametrize(
    ("codec", "suffix", "options", "has_starts"),
    [
        ("libx264", "mp4", {"g": "12", "bf": "3"}, True),
        ("libx264", "mkv", {"g": "12", "bf": "3"}, True),
        # In these files, frames after a key frame may refer to frames before it, or any packet may contain
        # parameters.
        ("libx264", "mp4", {"g": "12", "bf": "3", "x264-params": "open-gop=1:scenecut=0"}, False),
        ("libx264", "mp4", {"g": "12", "x264-params": "intra-refresh=1:scenecut=0"}, False),
        ("libx264", "ts", {"g": "12"}, False),
        ("libx265", "mp4", {"g": "12", "x265-params": "open-gop=0:log-level=none"}, True),
        ("libvpx-vp9", "webm", {"g": "12"}, True),
        ("mjpeg", "mov", {}, True),
        ("mpeg4", "mp4", {"g": "12", "bf": "2"}, False),
    ],
)
def test_decoding_from_a_later_frame_on_gives_the_same_bytes(codec, suffix, options, has_starts, tmp_path):
    tick = Fraction(1, 300 if codec == "mpeg4" else 90000)
    path = write_clip(tmp_path / f"a.{suffix}", steady(60), codec=codec, options=options, tick=tick)
    recording = Recording(path)
    whole = {picture.number: picture.image().tobytes() for picture in recording.pictures()}
    assert (recording.start_before(60) > 1) == has_starts
    for first in (2, 12, 13, 14, 24, 30, 49, 60):
        part = {picture.number: picture.image().tobytes() for picture in recording.pictures(first)}
        assert list(part) == list(range(first, 61))
        assert all(whole[number] == image for number, image in part.items())
        assert recording.lost == []


def test_a_damaged_frame_is_the_same_from_a_later_frame_on(tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(60))
    zero(path, 40)
    recording = Recording(path)
    whole = {picture.number: picture.image().tobytes() for picture in recording.pictures()}
    note = recording.note()
    for first in (1, 20, 37, 45, 55):
        again = Recording(path)
        part = {picture.number: picture.image().tobytes() for picture in again.pictures(first)}
        assert part == {number: image for number, image in whole.items() if number >= first}
        assert again.lost == [number for number in recording.lost if number >= first]
    assert 40 in recording.lost and "frame 40" in note


def test_flipped_bits_in_a_complete_container_are_reported(tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(40), options=CHAIN | {"preset": "medium"}, size=(160, 120))
    whole = Recording(path)
    right = {picture.number: picture.image() for picture in whole.pictures()}
    assert whole.note() == ""
    content, found = path.read_bytes(), 0
    for seed in range(8):
        path.write_bytes(content)
        flip(path, 11 + seed, seed)
        recording = Recording(path)
        got = {picture.number: picture.image() for picture in recording.pictures()}
        if len(got) < 40 or any(not np.array_equal(got[number], right[number]) for number in got):
            found += 1
            assert f"{11 + seed}" in recording.note()
            assert recording.lost == [11 + seed] or recording.damaged[0] == 11 + seed
    assert found > 4


def test_a_reader_that_stops_early_does_not_wait_for_the_decoder(tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(60))
    for number in range(5, 60, 3):
        flip(path, number, number)
    for count in range(1, 20):
        pictures = Recording(path).pictures()
        for _ in range(count):
            next(pictures)
        pictures.close()


def test_a_still_picture_between_thousands_of_packets_of_sound_is_not_the_end(tmp_path):
    times = [*steady(45), *(45 + np.arange(45) / 30)]
    path = write_clip(tmp_path / "a.mkv", times, tick=MILLI, sound=True)
    assert len(by_opencv(path)) < 90
    recording = Recording(path)
    assert shown(recording) == intact(90)
    assert np.allclose(recording.timing().seconds, times, atol=1e-3)
    assert recording.timing().fps == 30.0
    assert recording.note() == ""


def test_frames_have_the_times_of_the_file(tmp_path):
    times = [*steady(45), *(1.5 + np.arange(45) / 3)]
    recording = Recording(write_clip(tmp_path / "a.mp4", times))
    found = recording.timing()
    assert np.allclose(found.seconds, times, atol=1e-4)
    assert found.seconds[45] == 1.5
    assert found.fps == pytest.approx(30, rel=1e-3)
    assert np.array_equal(recording.timing(10.0).seconds, np.arange(90) / 10)


def test_a_rate_that_cannot_be_is_measured_or_asked_for(tmp_path):
    times = [0, 0.040, 0.069, 0.109, 0.138, 0.178]
    path = write_clip(tmp_path / "a.webm", times, codec="libvpx", rate=1000, tick=MILLI)
    assert cv2.VideoCapture(str(path)).get(cv2.CAP_PROP_FPS) == 1000
    assert Recording(path).timing().fps == pytest.approx(28.09, abs=0.01)
    path = write_clip(tmp_path / "b.webm", np.arange(6) / 1000, codec="libvpx", rate=1000, tick=MILLI)
    with pytest.raises(
        PlacecatError,
        match=r"b\.webm: the video has no plausible times .*1000\); set the frame rate with --fps",
    ):
        Recording(path).timing(None, "--fps")
    assert Recording(path).timing(30.0).fps == 30.0


def test_times_that_jump_by_hours_are_damaged(tmp_path):
    recording = Recording(write_clip(tmp_path / "a.mp4", [*steady(5), 9000.0], tick=Fraction(1, 600)))
    with pytest.raises(PlacecatError, match=r"frame 6 comes 2\.5 hours after .* with dataset\.fps"):
        recording.timing()


def test_pixels_that_are_not_square_are_made_so(tmp_path):
    recording = Recording(write_clip(tmp_path / "a.mp4", steady(3), size=(48, 48), shape=Fraction(4, 3)))
    assert recording.size() == (64, 48)
    assert shown(recording) == intact(3)
    assert {picture.image().shape for picture in recording.pictures()} == {(48, 64, 3)}
    path = write_clip(tmp_path / "b.mp4", steady(3), shape=Fraction(8, 1))
    with pytest.raises(PlacecatError, match=r"b\.mp4: .* pixels are 8 times as wide as they are high"):
        Recording(path)


@pytest.mark.parametrize("turn", [90, 180, 270])
def test_a_turned_phone_films_upright(turn, tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(3), turn=turn)
    recording = Recording(path)
    images = [picture.image() for picture in recording.pictures()]
    assert recording.size() == ((HEIGHT, WIDTH) if turn != 180 else (WIDTH, HEIGHT))
    assert np.array_equal(images, by_opencv(path))
    assert decoded(np.ascontiguousarray(np.rot90(images[1], -turn // 90))) == 1


def test_a_phone_turned_while_filming_does_not_stretch(tmp_path):
    recording = Recording(turned_on_the_way(tmp_path / "a.webm"))
    sizes = [picture.size for picture in recording.pictures()]
    assert sizes == [(WIDTH, HEIGHT)] * 5 + [(HEIGHT, WIDTH)] * 5
    assert [one for _, one in shown(recording)] == [*range(5), *range(5)]


def test_a_cover_is_no_video(tmp_path):
    path = tmp_path / "a.mp4"
    write_clip(tmp_path / "film.mp4", steady(5))
    jpeg = cv2.imencode(".jpg", np.zeros((90, 90, 3), np.uint8))[1].tobytes()
    with av.open(str(path), "w") as container, av.open(str(tmp_path / "film.mp4")) as film:
        cover = container.add_stream("mjpeg", rate=1)
        cover.width, cover.height, cover.pix_fmt = 90, 90, "yuvj420p"
        cover.disposition = av.stream.Disposition.attached_pic
        copy = container.add_stream_from_template(film.streams.video[0])
        picture = av.Packet(jpeg)
        picture.stream, picture.pts, picture.dts = cover, 0, 0
        picture.time_base = Fraction(1, 1)
        container.start_encoding()
        container.mux(picture)
        for packet in film.demux(video=0):
            if packet.size:
                packet.stream = copy
                container.mux(packet)
    with av.open(str(path)) as container:
        assert any(one.disposition & av.stream.Disposition.attached_pic for one in container.streams.video)
    recording = Recording(path)
    assert recording.size() == (WIDTH, HEIGHT)
    assert shown(recording) == intact(5)


@pytest.mark.parametrize("start", [12, 17, 30])
def test_a_trimmed_file_has_its_frames_and_no_note(start, tmp_path):
    whole = write_clip(tmp_path / "a.mp4", steady(40), options={"g": "12", "bf": "2", "sc_threshold": "0"})
    recording = Recording(copied(whole, tmp_path / "b.mp4", key=start // 12 * 12, start=start))
    assert shown(recording) == [(number + 1, start + number) for number in range(40 - start)]
    assert recording.timing().seconds[0] == 0
    assert recording.note() == ""


@pytest.mark.parametrize("ending", ["mp4", "mkv", "avi"])
@pytest.mark.parametrize("share", [0.6, 0.97])
def test_a_truncated_file_is_reported(ending, share, tmp_path):
    settings = {"codec": "mjpeg", "tick": Fraction(1, 30)} if ending == "avi" else {}
    path = write_clip(tmp_path / f"a.{ending}", steady(60), **settings)
    assert Recording(path).note() == ""
    content = path.read_bytes()
    position, size = packets(path)[round(share * 60)]
    path.write_bytes(content[: position + size // 2])
    recording = Recording(path)
    assert 0.5 * 60 < len(shown(recording)) < 60
    assert "may be cut off" in recording.note() or "is damaged: more" in recording.note()


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("a.mp4", {}),
        ("b_frames.mp4", {"options": {"g": "12", "bf": "2"}}),
        ("b_frames.avi", {"options": {"g": "12", "bf": "2"}, "tick": Fraction(1, 30)}),
        ("colour.mp4", {"color": 1}),
        ("odd.mkv", {"size": (98, 50)}),
        ("hidden.webm", {"codec": "libvpx", "options": {"auto-alt-ref": "1", "lag-in-frames": "16"}}),
        ("motion.avi", {"codec": "mjpeg", "tick": Fraction(1, 30)}),
        ("old.mov", {"codec": "mpeg4"}),
    ],
)
def test_whole_files_give_the_bytes_of_opencv_and_no_note(name, settings, tmp_path):
    path = write_clip(tmp_path / name, steady(40), **({"tick": MILLI} | settings))
    recording = Recording(path)
    assert np.array_equal([picture.image() for picture in recording.pictures()], by_opencv(path))
    assert recording.note() == ""
    assert recording.count == 40
    found = recording.timing()
    assert found.fps == cv2.VideoCapture(str(path)).get(cv2.CAP_PROP_FPS)
    assert np.array_equal(found.seconds, np.arange(40) / found.fps)


@pytest.mark.parametrize(
    "text",
    [
        "ffconcat version 1.0\nfile film.mp4\n",
        "#EXTM3U\n#EXT-X-TARGETDURATION:9\n#EXTINF:9,\nfilm.mp4\n#EXT-X-ENDLIST\n",
    ],
)
def test_a_list_of_other_files_is_not_followed(text, tmp_path):
    write_clip(tmp_path / "film.mp4", steady(3))
    (tmp_path / "a.mp4").write_text(text)
    with pytest.raises(PlacecatError, match=r"a\.mp4: not a readable video"):
        Recording(tmp_path / "a.mp4")


def test_messages(tmp_path):
    with pytest.raises(PlacecatError, match=r"a\.mp4: the video is missing"):
        Recording(tmp_path / "a.mp4")
    (tmp_path / "a.mp4").write_bytes(b"text")
    with pytest.raises(PlacecatError, match=r"a\.mp4: not a readable video"):
        Recording(tmp_path / "a.mp4")
    write_video(tmp_path / "b.avi", 3)
    content = (tmp_path / "b.avi").read_bytes()
    (tmp_path / "b.avi").write_bytes(content[: packets(tmp_path / "b.avi")[0][0]])
    with pytest.raises(PlacecatError, match=r"b\.avi: .*no readable frame|b\.avi: not a readable video"):
        Recording(tmp_path / "b.avi")
    shutil.rmtree(tmp_path)


def test_a_damaged_index_is_detected_by_the_length_of_the_film(tmp_path):
    path = write_clip(tmp_path / "a.mp4", steady(60))
    content = bytearray(path.read_bytes())
    counts = content.index(b"stsz") + 12
    assert int.from_bytes(content[counts : counts + 4], "big") == 60
    content[counts : counts + 4] = (20).to_bytes(4, "big")
    path.write_bytes(content)
    recording = Recording(path)
    assert len(shown(recording)) < 60
    assert "it ends 1.3 s early: it may be cut off" in recording.note()
