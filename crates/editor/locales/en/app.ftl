# The window itself.
app-untitled = untitled
app-saved = Saved: { $name }
app-picture-saved = Picture saved: { $path }
app-picture-noisy = The noise is still in the picture: { $error }
app-picture-no-denoiser = The noise is still in the picture: Open Image Denoise 2, which takes it out, is not installed
app-picture-not-saved = The render was stopped, so the picture was not saved. “Picture” saves it as it is now.
app-picture-for-nothing = Select what the picture is to cover, then drop it again
app-nothing-to-frame = There is nothing to show: planes have no end
app-no-autosave = Nothing is kept for the case of a crash: { $reason }
