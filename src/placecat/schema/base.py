"""Types that the sections of the schema share."""

from typing import Annotated, Any, Literal

from annotated_types import MinLen
from pydantic import BaseModel, ConfigDict

from placecat.ranges import Seed
from placecat.schema.names import Distinct, Key

# Settings that are checked by the function that takes them.
Own = dict[str, Any]
Seeds = Annotated[Distinct[Seed], MinLen(1)]
Schemes = Annotated[Distinct[Literal["5-5-1", "4-5-1"]], MinLen(1)]
# Names of cues, descriptors and so on; :mod:`placecat.schema.references` checks that they exist.
Keys = Distinct[Key]


class Section(BaseModel):
    """A mapping with exactly these settings and types."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)
