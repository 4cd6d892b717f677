## The strip of materials.
