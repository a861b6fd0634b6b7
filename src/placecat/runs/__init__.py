"""Keep results right when runs are killed, started twice, or their settings change."""
