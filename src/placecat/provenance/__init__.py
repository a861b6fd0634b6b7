"""The origin of each number: its definition, settings, frames, seeds and stages."""
