## The picture in the window.
viewport-picture = Изображение
viewport-move = Двигать
    .tooltip = Двигать выбранное за стрелки (W). С Ctrl — шагами по 0,25 м. Предметы можно тянуть и прямо по полу, с Shift — вверх и вниз.
viewport-turn = Поворачивать
    .tooltip = Поворачивать выбранное за кольца (E). С Ctrl — шагами по 15°.
viewport-size = Размер
    .tooltip = Увеличивать и уменьшать выбранное за кубики, за средний — сразу по всем направлениям (R). С Ctrl — шагами в четверть размера.
viewport-focus = В центр
    .tooltip = Показать выбранное в середине изображения; если ничего не выбрано — всё
viewport-degrees = { $angle }°
viewport-rendering = Идёт расчёт…
viewport-error = Изображения нет: { $message }
viewport-panic = Сбой расчёта изображения, сцена цела. ({ $message })
