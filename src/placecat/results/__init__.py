"""What a run measured: typed results, and where they are on disk."""
