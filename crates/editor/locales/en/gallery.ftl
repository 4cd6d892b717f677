## The gallery at the start.

gallery-title = Vitrine
gallery-about = Pictures of things behind glass
gallery-open = Open…
    .tooltip = Open a scene from a file
gallery-return = Back to the scene
    .tooltip = Close this screen and go on with the scene that is open
gallery-recent = Recent scenes
gallery-recent-below = { $folder } · { $age }
gallery-language = Language of the window
gallery-begin = Begin with
gallery-course-work = From the course work
gallery-card =
    .tooltip = Begin with a copy of this scene. { $about }
gallery-recover-title = “{ $name }” was not saved
gallery-recover-below = Vitrine was closed unexpectedly. Kept { $age }.
gallery-recover = Recover
    .tooltip = Open the scene as it was kept
gallery-discard = Discard
    .tooltip = Throw these changes away for good
gallery-age-now = just now
gallery-age-minutes = { $count ->
    [one] { $count } minute ago
   *[other] { $count } minutes ago
}
gallery-age-hours = { $count ->
    [one] { $count } hour ago
   *[other] { $count } hours ago
}
gallery-age-days = { $count ->
    [one] yesterday
   *[other] { $count } days ago
}
