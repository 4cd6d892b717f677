## Галерея при запуске.

gallery-title = Vitrine
gallery-about = Картинки предметов за стеклом
gallery-open = Открыть…
    .tooltip = Открыть сцену из файла
gallery-return = Вернуться к сцене
    .tooltip = Закрыть этот экран и продолжить работу с открытой сценой
gallery-recent = Недавние сцены
gallery-recent-below = { $folder } · { $age }
gallery-language = Язык окна
gallery-begin = Начать с готовой сцены
gallery-course-work = Из курсовой работы
gallery-card =
    .tooltip = Начать с копии этой сцены. { $about }
gallery-recover-title = Сцена «{ $name }» не сохранена
gallery-recover-below = Vitrine закрылась неожиданно. Копия сделана { $age }.
gallery-recover = Восстановить
    .tooltip = Открыть сохранённую копию сцены
gallery-discard = Удалить копию
    .tooltip = Отказаться от этих изменений навсегда
gallery-age-now = только что
gallery-age-minutes = { $count ->
    [one] { $count } минуту назад
    [few] { $count } минуты назад
   *[other] { $count } минут назад
}
gallery-age-hours = { $count ->
    [one] { $count } час назад
    [few] { $count } часа назад
   *[other] { $count } часов назад
}
gallery-age-days = { $count ->
    [one] { $count } день назад
    [few] { $count } дня назад
   *[other] { $count } дней назад
}
