"""The static site: pages of docs, the suite, the notebooks and a page to try, in one style."""
