"""Times as people read them."""


def clock(seconds: float) -> str:
    """Minutes and seconds, with hours if there are any, e.g. "0:07" or "1:02:03"."""
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
