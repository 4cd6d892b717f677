## The picture in the window.
