## What controls say.

unit-metres = m
unit-degrees = °
unit-pixels = px

widgets-mixed = mixed
widgets-auto = auto
widgets-choose = choose…
widgets-none = none
widgets-no-number = “{ $text }” is not a number
widgets-whole-only = Whole numbers only
widgets-from-to = From { $min } to { $max }
widgets-more-than = Must be more than { $min }
widgets-at-least = { $min } or more
widgets-at-most = { $max } or less
widgets-too-large = This number is too large
widgets-slider = { $name }, slider
widgets-axis-of = { $name } { $axis }
widgets-fold = Hide this part
widgets-unfold = Show this part
widgets-choose-file = Choose a file
    .tooltip = Choose the file from a list
widgets-clear = Clear
    .tooltip = Empty the field and show everything again
widgets-open-picker = { $name }, picker
widgets-picker-shade = Shade
    .tooltip = Drag to make the colour stronger to the right and lighter upwards
widgets-picker-hue = Hue
    .tooltip = Drag along the rainbow to choose the hue
widgets-no-color = “{ $text }” is not a colour; write it like #c8281e
widgets-texture-none = none
widgets-texture-pattern = New pattern
widgets-texture-file = Choose a picture file…
widgets-width = Width
widgets-height = Height
