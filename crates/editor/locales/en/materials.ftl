## The strip of materials.

materials-search = Search materials
    .tooltip = Words of the material that you want: glass, green, metal
materials-all = All
materials-scene = In the scene
materials-shelf = Show these materials: { $name }
materials-none = No material is found by these words
materials-needs-selection = Select an object first, or drag the material onto it
materials-own =
    .tooltip = The scene’s material “{ $name }”. Click to give it to what is selected, or drag it onto a thing.
materials-library =
    .tooltip = { $about } Click to give it to what is selected, or drag it onto a thing.
