"""Make homes from 360-degree pictures with seeded virtual walks (``placecat import panoramas``)."""
