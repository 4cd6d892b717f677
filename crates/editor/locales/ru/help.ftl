# Справка: клавиши, словарь, знакомство, о программе.

help-shortcuts-title = Сочетания клавиш
help-shortcuts-mouse = Мышь на картинке
help-shortcuts-mouse-select = Щелчок
    .what = Выделить предмет
help-shortcuts-mouse-focus = Двойной щелчок
    .what = Показать в середине
help-shortcuts-mouse-orbit = Тянуть правой кнопкой
    .what = Обойти сцену вокруг
help-shortcuts-mouse-pan = Тянуть средней кнопкой
    .what = Сдвинуть картинку
help-shortcuts-mouse-zoom = Колесо
    .what = Ближе или дальше
shortcut-section-file = Файл
shortcut-section-edit = Правка
shortcut-section-view = Вид
shortcut-section-render = Картинка
shortcut-new = Новая сцена
shortcut-open = Открыть
shortcut-save = Сохранить
shortcut-save-as = Сохранить как
shortcut-save-picture = Сохранить картинку
shortcut-quit = Выйти
shortcut-undo = Отменить
shortcut-redo = Вернуть
shortcut-cut = Вырезать
shortcut-copy = Копировать
shortcut-paste = Вставить
shortcut-duplicate = Дублировать
shortcut-delete = Удалить
shortcut-rename = Переименовать
shortcut-select-all = Выделить всё
shortcut-group = Сгруппировать
shortcut-ungroup = Разгруппировать
shortcut-hide = Показать или скрыть
shortcut-drop = Поставить на пол
shortcut-frame = Показать в середине
shortcut-frame-all = Показать всё
shortcut-move = Двигать
shortcut-turn = Поворачивать
shortcut-size = Менять размер
shortcut-escape = Снять выделение
shortcut-start = Начать рендер
shortcut-stop = Остановить рендер
shortcut-settings = Настройки
shortcut-help = Сочетания клавиш

help-glossary-title = Словарь
help-glossary-search = Поиск
    .tooltip = Введите часть слова на любом из двух языков
help-glossary-nothing = Нет термина, в котором есть «{ $text }»
help-glossary-count = { $count ->
        [one] { $count } термин
        [few] { $count } термина
       *[other] { $count } терминов
    }

help-about-title = О программе Vitrine
help-about-version = Версия { $version }
help-about-text = Сцены за прозрачными поверхностями: соберите сцену, смотрите, как её строит трассировка лучей, сохраните картинку.
help-about-own = Vitrine — свободная программа под лицензиями MIT и Apache 2.0, на ваш выбор.
help-about-parts = В ней работают
help-about-part-egui = Окно
help-about-part-inter = Шрифт окна
help-about-part-phosphor = Значки
help-about-part-fluent = Тексты на нескольких языках
help-about-part-toml = Файлы сцен
help-about-part-images = Файлы картинок
help-about-part-glam = Векторы и матрицы

tour-title = Первая картинка за 60 секунд
tour-begin = Знакомство с программой
    .tooltip = Первая картинка за 60 секунд: окно само покажет как
tour-step = Шаг { $step } из { $all }
tour-skip = Пропустить
    .tooltip = Перейти к следующему шагу
tour-close = Закрыть
    .tooltip = Закончить знакомство. Оно останется в меню «Справка»
tour-again = Ещё раз
    .tooltip = Начать с первого шага
tour-finish = Готово
    .tooltip = Закрыть знакомство
tour-add = Добавьте шар
    .text = Нажмите «Сфера» на панели инструментов. Шар появится в сцене и встанет на пол.
tour-paint = Сделайте его из красного стекла
    .text = Щёлкните «Красное стекло» в полосе материалов или перетащите его на шар.
tour-move = Подвиньте шар
    .text = Потяните шар прямо на картинке. Он останется на полу, а картинка сразу последует за ним.
tour-render = Постройте картинку
    .text = Нажмите «Начать рендер»: теперь картинка вычисляется в полном размере и качестве.
tour-save = Сохраните картинку
    .text = Нажмите «Картинка», выберите место и сохраните.
tour-done = Ваша первая картинка готова
    .text = Вот и всё. Попробуйте теперь свет: чем больше дисковый источник, тем мягче тени.
