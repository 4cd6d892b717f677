## The panel of properties.

properties-name = Name
    .tooltip = What it is called in the list and in the scene file
properties-show = Show
    .tooltip = Show it in the picture, or hide it
properties-shape = Shape
properties-kind = Kind
    .tooltip = What kind of thing it is
properties-full-at = Own distance of full brightness
    .tooltip = Say yourself at which distance the photoreal picture shows this lamp as bright as the classic one. Otherwise it is the distance to the middle of all things
properties-place = Placement
properties-drop = Drop to floor
    .tooltip = Set it down on the floor or on whatever lies below it
properties-focus = Focus
    .tooltip = Bring it to the middle of the picture
properties-lock = Keep proportions
    .tooltip = Change all three sizes alike
properties-move-together = They move together.
properties-material = Material
properties-light = Light
properties-several = { $count } things selected
properties-different = These things have different shapes.
properties-model = Model settings
    .tooltip = Position, size, turn and material of this model
properties-reset = { $name }: automatic
    .tooltip = Forget this value and let it follow from the others again

properties-made-of = Made of
    .tooltip = The material of this thing; several things can share one
properties-new-material = New material
properties-new-material-name = material
properties-give-material = Give it a material
    .tooltip = Make a new material for this thing
properties-no-material = Without a material it is light grey; a model keeps its own.
properties-shared = { $count ->
    [one] { $count } thing is made of this; it changes, too.
   *[other] { $count } things are made of this; all of them change.
}
properties-own-copy = Make an own copy
    .tooltip = Give this thing a material of its own, so that the others stay as they are
properties-more = More
properties-more-remark = Physical values, named as in OpenPBR. What is marked “auto” follows from the rest.
properties-inside = Inside
properties-coat = Coat
properties-film = Thin film
properties-glow = Glow
properties-patterns = Patterns and relief
properties-pattern = Pattern
properties-new-pattern-name = pattern

properties-aim = Aimed by
    .tooltip = Aim the camera at a point, or turn it by angles
properties-aim-point = a point
properties-aim-turn = a turn
properties-lens = Lens
properties-blur = Blur out of focus
    .tooltip = Blur what is nearer or farther than the focus, as a photograph does. Only in photoreal pictures
properties-turn-by = Turn by an angle
properties-angle = Angle
    .tooltip = By how many degrees to turn; positive turns counter-clockwise seen from the axis's end
properties-axis = Axis { $axis }
    .tooltip = Turn about the world's { $axis } axis, through the camera
properties-turn = Turn
    .tooltip = Turn the camera by this angle about this axis
properties-look = In the picture
properties-look-at = Look at
    .tooltip = Aim the camera at the centre of a thing
properties-frame-all = Frame all
    .tooltip = Step back or forth until everything is in the picture

properties-scene = Scene
properties-nothing-selected = Nothing is selected. Click a thing in the picture or in the list to see its properties.
properties-about = About
    .tooltip = What the scene shows, in one line
properties-picture = Picture
