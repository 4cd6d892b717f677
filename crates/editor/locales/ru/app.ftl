# Само окно.
app-untitled = без имени
app-saved = Сохранено: { $name }
app-picture-saved = Картинка сохранена: { $path }
app-picture-noisy = Шум остался в картинке: { $error }
app-picture-no-denoiser = Шум остался в картинке: не установлен Open Image Denoise 2, который его убирает
app-picture-not-saved = Рендер остановлен, поэтому картинка не сохранена. «Картинка» сохранит её как есть.
app-picture-for-nothing = Выделите то, на что положить картинку, и перетащите её ещё раз
app-nothing-to-frame = Показывать нечего: у плоскостей нет края
app-no-autosave = На случай сбоя ничего не сохраняется: { $reason }
