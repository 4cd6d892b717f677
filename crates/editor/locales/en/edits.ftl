# Why an edit was not made.
edit-no-parameter = This cannot be set here: { $reason }
edit-no-thing = There is no such thing in the scene any more
edit-not-possible = This cannot be done with what is selected
edit-no-kind = There is no kind “{ $word }”
edit-name-empty = A name cannot be empty
edit-name-taken = The name “{ $name }” is taken. Choose another
edit-bad-numbers = These numbers mean nothing here
edit-file = The file cannot be used: { $reason }. { $help }
edit-not-a-scene = What was copied is no scene. Line { $line }: { $reason }. { $help }
edit-nothing-to-add = There is nothing to paste
edit-askew = “{ $name }” is stretched askew by its group and cannot keep its form without it. Make the group’s size the same along X, Y and Z first

# What a value can be.
allowed-flag = Yes or no
allowed-integer = A whole number from { $min } to { $max }
allowed-size = Width and height: whole numbers from { $min } to { $max }
allowed-finite = Any number, such as 0.5 or -2
allowed-more-than = A number greater than { $min }
allowed-at-least = A number of { $min } or more
allowed-at-most = A number of { $max } or less
allowed-from-to = A number from { $min } to { $max }
allowed-more-than-to = A number greater than { $min } and at most { $max }
allowed-direction = Three numbers, not all of them zero
allowed-scale = Numbers other than zero
allowed-color = A colour such as #c8281e
allowed-choice = One of: { $words }
allowed-text = Any text
allowed-reference = The name of something in the scene
allowed-file = The path of a file

# What is wrong with a scene as a whole.
problem-duplicate-name = The name “{ $name }” stands twice
problem-missing-reference = There is no “{ $name }” in the scene
problem-group-cycle = The group “{ $name }” would be inside itself
problem-flat-triangle = The three points lie on one line, so there is no triangle. Move one of them off the line
problem-look-at = The camera cannot look at the point where it stands
problem-fault = This does not go together: { $reason }
problem-picture-too-large = A picture of { $width } × { $height } pixels is too large
problem-no-light = No light is switched on, so the picture is black
problem-no-object = Nothing is shown, so the picture is empty
problem-camera-inside = The camera is inside “{ $name }”
