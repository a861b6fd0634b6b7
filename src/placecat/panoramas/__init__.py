"""Make homes from 360-degree images with seeded virtual walks (``placecat import panoramas``)."""
