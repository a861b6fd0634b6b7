"""Keep results correct if a run is killed, is started twice, or its settings change."""
