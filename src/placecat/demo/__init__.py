"""A first minute: five homes train a system, which then walks through a sixth."""
