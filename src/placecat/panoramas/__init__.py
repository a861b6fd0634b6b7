"""Homes from 360-degree pictures: seeded walks of a view through them (``placecat import panoramas``)."""
