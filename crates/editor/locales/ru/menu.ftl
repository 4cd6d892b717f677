## The menu.
