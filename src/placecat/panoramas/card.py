"""The data card of homes made from panoramas, the README.md in their folder."""

from collections.abc import Mapping, Sequence
from typing import Any

import yaml

from placecat import __version__
from placecat.errors import one_line
from placecat.panoramas.labels import counts
from placecat.panoramas.panorama import Panorama
from placecat.panoramas.plan import Look, seed, unseen
from placecat.templates import environment

FILE = "README.md"


def card(
    plans: Mapping[str, Mapping[str, Sequence[Look]]],
    panoramas: Sequence[Panorama],
    settings: Mapping[str, Any],
    folder: str,
) -> str:
    """Render the card from `plans`, which map each home and floor to its looks.

    `panoramas` are all panoramas of the source, including those in no frame; `settings` come from
    conf/panoramas.yaml; `folder` is the source folder's name.
    """
    looks = [look for floors in plans.values() for own in floors.values() for look in own]
    by_home = {_plain(home): counts(floors) for home, floors in plans.items()}
    return (
        environment("placecat.panoramas")
        .get_template("card.md.j2")
        .render(
            version=__version__,
            panoramas=len(panoramas),
            unseen=[_plain(one.files[0]) for one in unseen(panoramas, plans)],
            folder=_plain(folder),
            frames=sum(len(look.path) for look in looks),
            counts=by_home,
            labels=sorted({label for own in by_home.values() for label in own}),
            seeds=[
                (_plain(home), floor, seed(home, floor, settings["walk"]))
                for home, floors in plans.items()
                for floor in floors
            ],
            settings=settings,
            settings_text=yaml.safe_dump(dict(settings), sort_keys=False, allow_unicode=True),
        )
    )


def _plain(text: str) -> str:
    """Make a name safe for Markdown tables and code spans."""
    return one_line(text).replace("|", "/").replace("`", "'")
