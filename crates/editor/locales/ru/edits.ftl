# Почему правка не сделана.
edit-no-parameter = Здесь это нельзя задать: { $reason }
edit-no-thing = Этого в сцене больше нет
edit-not-possible = С выделенным так сделать нельзя
edit-no-kind = Нет вида «{ $word }»
edit-name-empty = Имя не может быть пустым
edit-name-taken = Имя «{ $name }» занято. Выберите другое
edit-bad-numbers = Эти числа здесь не имеют смысла
edit-file = Файл не подходит: { $reason }. { $help }
edit-not-a-scene = Скопированное — не сцена. Строка { $line }: { $reason }. { $help }
edit-nothing-to-add = Вставлять нечего
edit-askew = Группа растягивает «{ $name }» наискось, и без группы форма не сохранится. Сначала сделайте размер группы одинаковым по X, Y и Z

# Каким может быть значение.
allowed-flag = Да или нет
allowed-integer = Целое число от { $min } до { $max }
allowed-size = Ширина и высота: целые числа от { $min } до { $max }
allowed-finite = Любое число, например 0.5 или -2
allowed-more-than = Число больше { $min }
allowed-at-least = Число не меньше { $min }
allowed-at-most = Число не больше { $max }
allowed-from-to = Число от { $min } до { $max }
allowed-more-than-to = Число больше { $min } и не больше { $max }
allowed-direction = Три числа, не все из них нули
allowed-scale = Числа, отличные от нуля
allowed-color = Цвет, например #c8281e
allowed-choice = Одно из: { $words }
allowed-text = Любой текст
allowed-reference = Имя чего-то из этой сцены
allowed-file = Путь к файлу

# Что не так со сценой в целом.
problem-duplicate-name = Имя «{ $name }» встречается дважды
problem-missing-reference = В сцене нет «{ $name }»
problem-group-cycle = Группа «{ $name }» оказалась бы внутри самой себя
problem-flat-triangle = Три точки лежат на одной прямой, и треугольника нет. Сдвиньте одну из них
problem-look-at = Камера не может смотреть в точку, где она стоит
problem-fault = Это не сочетается: { $reason }
problem-picture-too-large = Картинка { $width } × { $height } пикселей слишком велика
problem-no-light = Ни один источник света не включён, поэтому картинка чёрная
problem-no-object = Ничего не показано, поэтому картинка пустая
problem-camera-inside = Камера внутри «{ $name }»
