"""Strip lights and notices for any room in an office building."""

from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.ceiling_strip import ceiling_strip
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.notice_board import calendar, notice_board, papers_on_wall, wall_poster
from placecat_homes.placing.room import Room


def strip_lights(room: Room, *, apart: float = 2.6) -> None:
    """Fix identical strip lights to the ceiling in one or two rows.

    Parameters
    ----------
    room
        The room.
    apart
        Approximate distance in metres between lights along the room.
    """
    rng, style = room.rng, room.style
    along = room.width >= room.depth
    longer, shorter = max(room.width, room.depth), min(room.width, room.depth)
    light = ceiling_strip(rng, style)
    crosswise = chance(rng, 0.4) and shorter > 2.2
    if along == crosswise:
        light = light.turned(90)
    count = max(1, round(longer / apart))
    rows = 2 if shorter > 3.6 and chance(rng, 0.6) else 1
    for k in range(count):
        for row in range(rows):
            x, y = (k + 0.5) * longer / count, (row + 0.5) * shorter / rows
            room.ceiling(light, x=x if along else y, y=y if along else x)


def notices(room: Room, count: int, *, boards: bool = True) -> None:
    """Hang notice boards, posters, calendars, loose sheets and a clock on the walls.

    Parameters
    ----------
    room
        The room.
    count
        Number of objects.
    boards
        Whether notice boards are allowed.
    """
    rng, style = room.rng, room.style
    for _ in range(count):
        kind = choose(rng, ("board", "poster", "papers", "calendar"), (2.5 if boards else 0, 2.5, 1, 0.7))
        if kind == "board":
            placed = room.hang(notice_board(rng, style), bottom=between(rng, 0.95, 1.15))
            if placed is None:
                room.hang(notice_board(rng, style, 0.7, 0.6), bottom=1.2)
        elif kind == "poster":
            room.hang(wall_poster(rng, style), bottom=between(rng, 0.85, 1.1))
        elif kind == "papers":
            sheets = papers_on_wall(rng, style, between(rng, 0.4, 1.0), between(rng, 0.4, 0.7))
            room.hang(sheets, bottom=between(rng, 1.0, 1.25))
        else:
            room.hang(calendar(rng, style), bottom=between(rng, 1.2, 1.4))
    if chance(rng, 0.3):
        room.hang(clock(rng, style), bottom=between(rng, 1.8, 2.0))
