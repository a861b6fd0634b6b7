"""Format times for display."""


def clock(seconds: float) -> str:
    """Format seconds as minutes and seconds, and hours if needed, e.g. "0:07" or "1:02:03"."""
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
