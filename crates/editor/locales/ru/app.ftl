# Само окно.
app-untitled = без имени
app-saved = Сохранено: { $name }
app-picture-saved = Картинка сохранена: { $path }
app-picture-not-saved = Рендер остановлен, поэтому картинка не сохранена. «Картинка» сохранит её как есть.
app-picture-for-nothing = Выделите то, на что положить картинку, и перетащите её ещё раз
app-nothing-to-frame = Показывать нечего: у плоскостей нет края
app-no-autosave = На случай сбоя ничего не сохраняется: { $reason }
app-moments-ago = только что
app-minutes-ago = { $count ->
        [one] { $count } минуту назад
        [few] { $count } минуты назад
       *[many] { $count } минут назад
    }
app-hours-ago = { $count ->
        [one] { $count } час назад
        [few] { $count } часа назад
       *[many] { $count } часов назад
    }
app-days-ago = { $count ->
        [one] { $count } день назад
        [few] { $count } дня назад
       *[many] { $count } дней назад
    }
