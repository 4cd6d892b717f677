# Диалоги.

dialog-ok = Готово
    .tooltip = Принять и закрыть (Enter)
dialog-cancel = Отмена
    .tooltip = Закрыть, ничего не меняя (Esc)
dialog-close = Закрыть
    .tooltip = Закрыть это окно (Esc)
dialog-copy = Копировать
    .tooltip = Скопировать текст, чтобы послать его или найти ответ
dialog-copied = Скопировано

# Добавить и изменить
dialog-add-title = Добавить: { $kind }
dialog-edit-title = Изменить: { $name }
dialog-add-ok = Добавить
    .tooltip = Поместить в сцену (Enter)
dialog-edit-ok = Применить
    .tooltip = Принять изменения одним шагом, который можно отменить (Enter)
dialog-add-name = Имя
    .tooltip = Под этим именем предмет стоит в списке
dialog-add-name-empty = Дайте имя
dialog-add-name-taken = Такое имя уже занято
dialog-add-material = Материал
dialog-add-preview = Предпросмотр
    .tooltip = Как будет выглядеть сцена
dialog-add-preview-none = Картинки пока нет
dialog-add-material-choice = Из чего
    .tooltip = Новый материал, один из материалов сцены или собственный материал модели
dialog-add-material-new = Новый материал
dialog-add-material-own = Как в файле
dialog-add-material-none = Светло-серый
dialog-add-material-shared = { $count ->
        [one] Из него сделан ещё { $count } предмет — он тоже изменится
        [few] Из него сделаны ещё { $count } предмета — они тоже изменятся
       *[other] Из него сделаны ещё { $count } предметов — они тоже изменятся
    }
dialog-add-fault-line = Три точки лежат на одной прямой, треугольника нет

# Модель
dialog-model-title = Настройка модели
dialog-model-ok = Добавить
    .tooltip = Поместить модель в сцену (Enter)
dialog-model-size = Размер
dialog-model-size-of = { $width } × { $height } × { $depth } м
    .tooltip = Ширина × высота × глубина в метрах
dialog-model-triangles = Треугольники
dialog-model-file = Файл
dialog-model-units = Единицы файла
    .tooltip = Что означают числа в файле. Программы для станков и принтеров чаще всего пишут миллиметры
dialog-model-unit-metre = Метры
dialog-model-unit-centimetre = Сантиметры
dialog-model-unit-millimetre = Миллиметры
dialog-model-unit-inch = Дюймы
dialog-model-up = Вверх идёт
    .tooltip = Какая ось файла направлена вверх. Если модель лежит на спине, выберите другую
dialog-model-up-y = Ось Y
dialog-model-up-z = Ось Z
dialog-model-stand = Поставить на пол
    .tooltip = Нижняя точка модели окажется на земле
dialog-model-warnings = { $count ->
        [one] { $count } замечание о файле
        [few] { $count } замечания о файле
       *[other] { $count } замечаний о файле
    }
dialog-model-hint-huge = Больше 100 м: верны ли единицы?
dialog-model-hint-tiny = Меньше 1 мм: верны ли единицы?

# Сохранить картинку
dialog-save-title = Сохранить картинку
dialog-save-ok = Сохранить
    .tooltip = Сохранить картинку (Enter)
dialog-save-render-ok = Построить и сохранить
    .tooltip = Построить картинку этого размера и сохранить её (Enter)
dialog-save-source = Картинка
    .tooltip = Картинка, как она построена до сих пор, или новая
dialog-save-source-current = Как есть сейчас
    .tooltip = Картинка, как она построена до сих пор: { $width } × { $height }, проходов: { $passes }
dialog-save-source-render = Построить новую
    .tooltip = Строит новую картинку с размером и качеством, заданными ниже
dialog-save-preset = Частые размеры
    .tooltip = Размеры, которые часто нужны
dialog-save-preset-scene = Как в сцене
dialog-save-preset-course = Курсовая работа
dialog-save-preset-hd = HD
dialog-save-preset-full-hd = Full HD
dialog-save-preset-4k = 4K
dialog-save-preset-square = Квадрат
dialog-save-preset-own = Свой размер
dialog-save-width = Ширина
    .tooltip = Ширина картинки в пикселях
dialog-save-height = Высота
    .tooltip = Высота картинки в пикселях
dialog-save-size = Размер
dialog-save-ratio = Сохранять отношение ширины и высоты
    .tooltip = Когда меняется одно, другое следует за ним
dialog-save-too-large = Не больше { $limit } миллионов пикселей
dialog-save-format = Формат
    .tooltip = Вид файла картинки
dialog-save-format-png8 = PNG
    .tooltip = На все случаи: без потерь, открывается любой программой
dialog-save-format-png16 = PNG, 16 бит
    .tooltip = Более тонкие ступени яркости, для дальнейшей обработки
dialog-save-format-jpeg = JPEG
    .tooltip = Маленькие файлы для писем и сайтов; мелкие детали теряются
dialog-save-format-exr = OpenEXR
    .tooltip = Весь диапазон света, для обработки в других программах
dialog-save-format-hdr = Radiance HDR
    .tooltip = Весь диапазон света, более старый формат
dialog-save-samples = Качество (выборки)
    .tooltip = Выборок на каждую точку картинки. Чем больше, тем ровнее края и мягче тени и тем дольше ждать
dialog-save-renderer = Рендерер
    .tooltip = Каким способом строится картинка
dialog-save-path = Файл
    .tooltip = Куда сохранить картинку
dialog-save-path-empty = Укажите, куда сохранить
dialog-save-replaces = Файл с таким именем уже есть, он будет заменён
dialog-save-no-folder = Такой папки нет
dialog-save-time = Займёт
dialog-save-time-unknown = пока неизвестно
dialog-save-time-none = нисколько
dialog-save-time-seconds = { $count ->
        [one] около { $count } секунды
       *[other] около { $count } секунд
    }
dialog-save-time-minutes = { $count ->
        [one] около { $count } минуты
       *[other] около { $count } минут
    }
dialog-save-time-hours = { $count ->
        [one] около { $count } часа
       *[other] около { $count } часов
    }

# Настройки
dialog-settings-title = Настройки
dialog-settings-picture = Картинка этой сцены
dialog-settings-machine = Эта машина
dialog-settings-window = Окно
dialog-settings-threads = Число потоков
    .tooltip = Сколько частей картинки вычисляется одновременно. «Все» — вся машина
dialog-settings-threads-all = Все ({ $count })
dialog-settings-depth = Глубина рекурсии отражений
    .tooltip = Сколько раз отражение может отразиться снова. Для большинства сцен хватает 3
dialog-settings-renderer = Рендерер
    .tooltip = Каким способом строится картинка
dialog-settings-renderer-classic = Классический
    .tooltip = Трассировка лучей с отражениями, прозрачностью и тенями
dialog-settings-renderer-cast = Бросание лучей
    .tooltip = Только ближайшая поверхность: без отражений, прозрачности и теней
dialog-settings-renderer-photoreal = Фотореалистичный
    .tooltip = Свет как в жизни: настоящее стекло, металлы и мягкий свет отовсюду. Сначала зернистый, потом чистый
dialog-settings-language = Язык
    .tooltip = Язык окна; меняется сразу
dialog-settings-large-text = Крупный текст
    .tooltip = Увеличивает все буквы
dialog-settings-high-contrast = Высокий контраст
    .tooltip = Сильнее разница между светлым и тёмным

# Вопросы
dialog-unsaved-title = Сохранить изменения?
dialog-unsaved-text = В сцене «{ $name }» есть несохранённые изменения. Без сохранения они пропадут.
dialog-unsaved-untitled = Новая сцена
dialog-unsaved-save = Сохранить
    .tooltip = Сохранить сцену и продолжить (Enter)
dialog-unsaved-drop = Не сохранять
    .tooltip = Продолжить; изменения пропадут
dialog-changed-title = Файл изменился
dialog-changed-text = Другая программа изменила файл «{ $name }».
dialog-changed-text-unsaved = Другая программа изменила файл «{ $name }», а у вас есть свои несохранённые изменения.
dialog-changed-reload = Прочитать заново
    .tooltip = Взять то, что теперь в файле; ваши изменения пропадут
dialog-changed-keep = Оставить мою
    .tooltip = Продолжить со сценой, какая она здесь (Esc)

# Сообщение об ошибке
dialog-error-title = Не получилось
dialog-error-scene = Сцену нельзя открыть
dialog-error-model = Модель нельзя прочитать
dialog-error-picture = Картинку нельзя сохранить
dialog-error-render = Картинку нельзя построить
dialog-error-line = Строка { $line }
dialog-error-help = Что поможет
dialog-error-kept = Открытая сцена осталась, какой была.

# Проблемы и доктор картинки
dialog-problems-title = Проблемы
dialog-problems-none = Со сценой всё в порядке
dialog-problems-fix = Исправить
    .tooltip = Исправить: { $mend }
dialog-problems-select = { $text }
    .tooltip = Выделить предмет, о котором речь
dialog-problems-error = Ошибка
dialog-problems-warning = Замечание
dialog-error-many = В этом файле ошибок: { $count }
