"""One picture for each idea of the pages, computed by the library and drawn in one style."""
