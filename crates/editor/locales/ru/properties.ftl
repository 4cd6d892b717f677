## The panel of properties.
