## What controls say.

unit-metres = м
unit-degrees = °
unit-pixels = пикс.

widgets-mixed = разные
widgets-auto = авто
widgets-choose = выбрать…
widgets-none = нет
widgets-no-number = «{ $text }» — не число
widgets-whole-only = Только целые числа
widgets-from-to = От { $min } до { $max }
widgets-more-than = Должно быть больше { $min }
widgets-at-least = Не меньше { $min }
widgets-at-most = Не больше { $max }
widgets-too-large = Слишком большое число
widgets-slider = { $name }, ползунок
widgets-axis-of = { $name } { $axis }
widgets-fold = Скрыть этот раздел
widgets-unfold = Показать этот раздел
widgets-choose-file = Выбрать файл
    .tooltip = Выбрать файл из списка
widgets-clear = Очистить
    .tooltip = Очистить поле и снова показать всё
widgets-open-picker = { $name }, палитра
widgets-picker-shade = Оттенок
    .tooltip = Вправо цвет насыщеннее, вверх — светлее
widgets-picker-hue = Цветовой тон
    .tooltip = Выберите тон на радуге
widgets-no-color = «{ $text }» — не цвет; запишите его как #c8281e
widgets-texture-none = нет
widgets-texture-pattern = Новый узор
widgets-texture-file = Выбрать файл картинки…
widgets-width = Ширина
widgets-height = Высота
