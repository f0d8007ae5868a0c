"""Mistakes a user can put right."""


class BadInput(Exception):
    """The message gives the place, what was found, what is required and the remedy."""
