"""Where each number comes from: its definition, settings, frames, seeds and stages."""
