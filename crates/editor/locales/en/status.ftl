# The line at the bottom of the window.
status-live = Live picture
status-pass = Pass { $pass } of { $passes }
status-samples = Samples: { $samples } of { $all }
status-live-samples = Samples: { $samples }
status-drawing = Drawing…
status-final = Rendering { $percent } %, { $left } left
status-final-starting = Rendering { $percent } %
status-stopped = Stopped at { $percent } %
status-done = Rendered in { $elapsed }
status-saved = Saved
status-unsaved = Not saved yet
status-changed = Changed
status-renderer = Renderer
    .tooltip = How the picture is made: with mirrors, transparency and shadows, by ray casting without any of them, or photoreal
status-threads = Threads: { $count }
    .tooltip = How many threads compute the picture. Click to change
status-depth = Depth: { $count }
    .tooltip = How many times a mirror image may be mirrored again. Click to change
status-problems = { $count ->
        [one] 1 problem
       *[other] { $count } problems
    }
    .tooltip = What may be wrong with the scene, and the mend
status-progress = Progress of the picture
    .tooltip = How much of the picture is finished
