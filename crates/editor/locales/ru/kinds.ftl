## Names of kinds and of choices.

kind-sphere = Сфера
kind-box = Параллелепипед
kind-plane = Плоскость
kind-triangle = Треугольник
kind-mesh = Модель
kind-object-disc = Диск

kind-ambient = Окружающее освещение
kind-point = Точечный источник
kind-directional = Направленный источник
kind-disc = Дисковый источник
kind-light-sphere = Шаровая лампа
kind-environment = Панорама
kind-sky = Небо и солнце

kind-picture = Картинка
kind-checker = Шахматная доска

kind-object = Объект
kind-light = Источник света
kind-group = Группа
kind-material = Материал
kind-texture = Узор
kind-camera = Камера
kind-settings = Картинка

choice-renderer-classic = Классический
choice-renderer-cast = Бросание лучей
choice-renderer-photoreal = Фотореалистичный
choice-view-none = по методу
choice-view-neutral = Верные цвета (neutral)
choice-view-agx = Как на плёнке (AgX)
choice-view-srgb = Без обработки (sRGB)
choice-metal-gold = Золото
choice-metal-copper = Медь
choice-metal-silver = Серебро
choice-metal-aluminium = Алюминий
choice-metal-chrome = Хром
choice-wrap-repeat = Повторять
choice-wrap-clamp = Крайние цвета
