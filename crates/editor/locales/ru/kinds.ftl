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
choice-wrap-repeat = Повторять
choice-wrap-clamp = Крайние цвета
