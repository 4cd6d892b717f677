# The dialogs.

dialog-ok = OK
    .tooltip = Accept and close (Enter)
dialog-cancel = Cancel
    .tooltip = Close and change nothing (Esc)
dialog-close = Close
    .tooltip = Close this window (Esc)
dialog-copy = Copy
    .tooltip = Copy the text, to send or to search for it
dialog-copied = Copied

# Add and edit
dialog-add-title = Add: { $kind }
dialog-edit-title = Edit: { $name }
dialog-add-ok = Add
    .tooltip = Put it into the scene (Enter)
dialog-edit-ok = Apply
    .tooltip = Take over the changes, as one step that can be undone (Enter)
dialog-add-name = Name
    .tooltip = What it is called in the list
dialog-add-name-empty = Give it a name
dialog-add-name-taken = There is already something with this name
dialog-add-material = Material
dialog-add-preview = Preview
    .tooltip = How the scene will look
dialog-add-preview-none = There is no picture yet
dialog-add-material-choice = Made of
    .tooltip = A new material, one that the scene has, or the model's own
dialog-add-material-new = New material
dialog-add-material-own = The model's own
dialog-add-material-none = Light grey
dialog-add-material-shared = { $count ->
        [one] One other thing is made of it and changes as well
       *[other] { $count } other things are made of it and change as well
    }
dialog-add-fault-line = The three points lie on one line, so there is no triangle

# Model
dialog-model-title = Model settings
dialog-model-ok = Add
    .tooltip = Put the model into the scene (Enter)
dialog-model-size = Size
dialog-model-size-of = { $width } × { $height } × { $depth } m
    .tooltip = Width × height × depth in metres
dialog-model-triangles = Triangles
dialog-model-file = File
dialog-model-units = Units of the file
    .tooltip = What the numbers in the file mean. Most programs for machines and printers use millimetres
dialog-model-unit-metre = Metres
dialog-model-unit-centimetre = Centimetres
dialog-model-unit-millimetre = Millimetres
dialog-model-unit-inch = Inches
dialog-model-up = Up is
    .tooltip = Which axis points up in the file. If the model lies on its back, choose the other one
dialog-model-up-y = Y axis
dialog-model-up-z = Z axis
dialog-model-stand = Stand on the floor
    .tooltip = Puts the lowest point of the model onto the ground
dialog-model-warnings = { $count ->
        [one] One remark about the file
       *[other] { $count } remarks about the file
    }
dialog-model-hint-huge = Larger than 100 m: are the units right?
dialog-model-hint-tiny = Smaller than 1 mm: are the units right?

# Save picture
dialog-save-title = Save picture
dialog-save-ok = Save
    .tooltip = Save the picture (Enter)
dialog-save-render-ok = Render and save
    .tooltip = Compute the picture at this size and save it (Enter)
dialog-save-source = Picture
    .tooltip = The picture as it has been computed so far, or a new one
dialog-save-source-current = As it is now
    .tooltip = The picture as it has been computed so far: { $width } × { $height }, { $passes } passes
dialog-save-source-render = Render now
    .tooltip = Computes a new picture with the size and quality below
dialog-save-preset = Common sizes
    .tooltip = Sizes that are often needed
dialog-save-preset-scene = As in the scene
dialog-save-preset-course = Course work
dialog-save-preset-hd = HD
dialog-save-preset-full-hd = Full HD
dialog-save-preset-4k = 4K
dialog-save-preset-square = Square
dialog-save-preset-own = Own size
dialog-save-width = Width
    .tooltip = Width of the picture in pixels
dialog-save-height = Height
    .tooltip = Height of the picture in pixels
dialog-save-size = Size
dialog-save-ratio = Keep the ratio of width and height
    .tooltip = When one of them changes, the other follows
dialog-save-too-large = At most { $limit } million pixels
dialog-save-format = Format
    .tooltip = The kind of picture file
dialog-save-format-png8 = PNG
    .tooltip = For everything: exact, every program can open it
dialog-save-format-png16 = PNG, 16 bit
    .tooltip = Finer steps of brightness, for later work on the picture
dialog-save-format-jpeg = JPEG
    .tooltip = Small files for letters and web pages; fine details are lost
dialog-save-format-exr = OpenEXR
    .tooltip = The full range of light, for work on the picture in other programs
dialog-save-format-hdr = Radiance HDR
    .tooltip = The full range of light, in an older format
dialog-save-samples = Quality (samples)
    .tooltip = Samples for each dot of the picture. More give smoother edges and softer shadows and take longer
dialog-save-renderer = Renderer
    .tooltip = How the picture is computed
dialog-save-path = File
    .tooltip = Where the picture is saved
dialog-save-path-empty = Say where to save it
dialog-save-replaces = A file of this name is there and will be replaced
dialog-save-no-folder = There is no such folder
dialog-save-time = Will take
dialog-save-time-unknown = not known yet
dialog-save-time-none = no time at all
dialog-save-time-seconds = { $count ->
        [one] about { $count } second
       *[other] about { $count } seconds
    }
dialog-save-time-minutes = { $count ->
        [one] about { $count } minute
       *[other] about { $count } minutes
    }
dialog-save-time-hours = { $count ->
        [one] about { $count } hour
       *[other] about { $count } hours
    }

# Settings
dialog-settings-title = Settings
dialog-settings-picture = Picture of this scene
dialog-settings-machine = This machine
dialog-settings-window = Window
dialog-settings-threads = Threads
    .tooltip = How many parts of the picture are computed at the same time. “All” uses the whole machine
dialog-settings-threads-all = All ({ $count })
dialog-settings-depth = Reflection depth
    .tooltip = How often a mirror image may be mirrored again. 3 is enough for most scenes
dialog-settings-renderer = Renderer
    .tooltip = How the picture is computed
dialog-settings-renderer-classic = Classic
    .tooltip = Ray tracing with mirrors, transparency and shadows
dialog-settings-renderer-cast = Ray casting
    .tooltip = Only the nearest surface: no mirrors, transparency or shadows
dialog-settings-renderer-photoreal = Photoreal
    .tooltip = Light as it is: true glass, metals and soft light from everywhere. Begins grainy and becomes clean
dialog-settings-language = Language
    .tooltip = The language of the window; changes at once
dialog-settings-large-text = Large text
    .tooltip = Makes all letters larger
dialog-settings-high-contrast = High contrast
    .tooltip = Stronger differences between light and dark

# Questions
dialog-unsaved-title = Save the changes?
dialog-unsaved-text = “{ $name }” has changes that have not been saved. Without saving they are lost.
dialog-unsaved-untitled = New scene
dialog-unsaved-save = Save
    .tooltip = Save the scene and go on (Enter)
dialog-unsaved-drop = Don't save
    .tooltip = Go on; the changes are lost
dialog-changed-title = The file has changed
dialog-changed-text = Another program has changed “{ $name }”.
dialog-changed-text-unsaved = Another program has changed “{ $name }”, and you have changes of your own that are not saved.
dialog-changed-reload = Read it again
    .tooltip = Take what the file says now; changes of your own are lost
dialog-changed-keep = Keep mine
    .tooltip = Go on with the scene as it is here (Esc)

# Error report
dialog-error-title = This did not work
dialog-error-scene = The scene cannot be opened
dialog-error-model = The model cannot be read
dialog-error-picture = The picture cannot be saved
dialog-error-render = The picture cannot be rendered
dialog-error-line = Line { $line }
dialog-error-help = What helps
dialog-error-kept = The open scene stays as it was.

# Problems and picture doctor
dialog-problems-title = Problems
dialog-problems-none = Nothing is wrong with the scene
dialog-problems-fix = Fix
    .tooltip = Mend this: { $mend }
dialog-problems-select = { $text }
    .tooltip = Select the thing that is meant
dialog-problems-error = Error
dialog-problems-warning = Remark
dialog-error-many = { $count } things are wrong in this file
