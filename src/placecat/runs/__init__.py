"""Correct results if runs are killed, started twice, or their settings change."""
