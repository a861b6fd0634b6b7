"""Compose params.yaml from conf/, and check it."""
