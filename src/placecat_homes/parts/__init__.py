"""Parts that several kinds of furniture are made of."""
