"""What the adapter refuses."""


class LayoutError(TypeError):
    """The degrees of freedom of a basis are not those of a displacement that contact can read."""
