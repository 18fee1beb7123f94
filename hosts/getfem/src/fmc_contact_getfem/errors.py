"""What the adapter refuses."""


class LayoutError(TypeError):
    """The unknowns of a variable are not those of a displacement that contact can read."""
