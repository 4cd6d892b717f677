## The picture in the window.
viewport-picture = Picture
viewport-move = Move
    .tooltip = Move what is selected by its arrows (W). Ctrl moves in steps of 0.25 m. Things themselves can be dragged along the floor, with Shift up and down.
viewport-turn = Turn
    .tooltip = Turn what is selected by its rings (E). Ctrl turns in steps of 15°.
viewport-size = Size
    .tooltip = Make what is selected larger or smaller by its boxes, the one in the middle in all directions (R). Ctrl goes in steps of a quarter of its size.
viewport-focus = Focus
    .tooltip = Bring what is selected to the middle of the picture; everything when nothing is selected
viewport-degrees = { $angle }°
viewport-rendering = Rendering…
viewport-error = No picture: { $message }
viewport-panic = The renderer has failed; the scene is not harmed. ({ $message })
