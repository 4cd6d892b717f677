## The list of things in the scene.
