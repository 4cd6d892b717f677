# Строка внизу окна.
status-live = Живая картинка
status-pass = Проход { $pass } из { $passes }
status-samples = Выборки: { $samples } из { $all }
status-live-samples = Выборки: { $samples }
status-drawing = Рисую…
status-final = Рендер { $percent } %, осталось { $left }
status-final-starting = Рендер { $percent } %
status-stopped = Остановлено на { $percent } %
status-done = Готово за { $elapsed }
status-saved = Сохранено
status-unsaved = Ещё не сохранено
status-changed = Изменено
status-renderer = Способ
    .tooltip = Как строится картинка: с отражениями, прозрачностью и тенями, бросанием лучей без них или фотореалистично
status-threads = Потоки: { $count }
    .tooltip = Сколько потоков считают картинку. Щёлкните, чтобы изменить
status-depth = Глубина: { $count }
    .tooltip = Сколько раз отражение может отразиться снова. Щёлкните, чтобы изменить
status-problems = { $count ->
        [one] { $count } проблема
        [few] { $count } проблемы
       *[many] { $count } проблем
    }
    .tooltip = Что может быть не так со сценой и как это исправить
status-progress = Ход построения картинки
    .tooltip = Какая часть картинки готова
