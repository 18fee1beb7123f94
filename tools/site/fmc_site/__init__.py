"""The static site: pages of docs, the suite, the notebook and a page to try, in one style."""
