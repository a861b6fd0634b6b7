"""Its folder comes onto the path, so that the tests below it can import `makers`."""
