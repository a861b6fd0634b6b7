"""Parts shared by several kinds of furniture."""
