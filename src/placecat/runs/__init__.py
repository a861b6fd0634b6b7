"""Keep results correct if a run is killed or started twice, or if its settings change."""
