"""Pictures out of files, with their times."""
