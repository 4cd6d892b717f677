# Why the picture is black, white or empty.
doctor-no-light = The picture is black because there is no light
doctor-lights-off = The picture is black because every light is switched off
doctor-lights-zero = The picture is black because the brightness of every light is zero
doctor-too-dark = The picture is dark because the lights are very weak
doctor-too-bright = The picture is white because the lights are too bright together
doctor-no-object = The picture is empty because there is nothing in the scene
doctor-all-hidden = The picture is empty because everything is hidden
doctor-camera-inside = The camera is inside “{ $name }”
doctor-camera-under = The camera is under “{ $name }”
doctor-all-behind = Everything is behind the camera
doctor-nothing-in-view = Nothing is in the camera’s view
doctor-camera-too-far = The camera is so far away that nothing can be made out
doctor-camera-too-near = The camera is too near to “{ $name }”

# What mends it.
doctor-mend-add-lamp = Add a lamp
doctor-mend-switch-on = Switch the lights on
doctor-mend-brighten = Brighten the lights
doctor-mend-dim = Dim the lights
doctor-mend-add-ball = Add a ball
doctor-mend-show-all = Show everything
doctor-mend-step-out = Step out of it
doctor-mend-step-up = Move above it
doctor-mend-step-back = Step back
doctor-mend-frame-all = Show everything in view

# Further problems.
problem-missing-picture = The picture { $path } is missing
problem-missing-model = The model { $path } is missing
problem-open-model = The model “{ $name }” is transparent and has holes, so it does not look like glass
problem-equal-solids = “{ $name }” and “{ $other }” are of different glass, overlap and are equally large, so it is chance which one counts there
problem-asset = { $text }
