"""Keep results correct even if a run is killed or started twice, or if its settings change."""
