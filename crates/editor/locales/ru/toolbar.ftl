## The toolbar.
