"""Make homes from 360-degree pictures by seeded virtual walks (``placecat import panoramas``)."""
