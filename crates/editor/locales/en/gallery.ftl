## The gallery at the start.
