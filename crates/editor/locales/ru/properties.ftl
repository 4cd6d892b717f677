## The panel of properties.

properties-name = Имя
    .tooltip = Как называется в списке и в файле сцены
properties-show = Показывать
    .tooltip = Показать на картинке или скрыть
properties-shape = Форма
properties-kind = Вид
    .tooltip = Что это такое
properties-full-at = Своё расстояние полной яркости
    .tooltip = Указать самому, на каком расстоянии лампа в фотореалистичной картинке так же ярка, как в классической. Иначе это расстояние до середины всех предметов
properties-place = Размещение
properties-drop = На пол
    .tooltip = Поставить на пол или на то, что находится ниже
properties-focus = К центру
    .tooltip = Показать в середине картинки
properties-lock = Сохранять пропорции
    .tooltip = Менять все три размера одинаково
properties-move-together = Перемещаются вместе.
properties-material = Материал
properties-light = Свет
properties-several = { $count ->
    [one] Выбран { $count } предмет
    [few] Выбрано { $count } предмета
   *[other] Выбрано { $count } предметов
}
properties-different = У выбранных предметов разная форма.
properties-model = Настройка модели
    .tooltip = Положение, размер, поворот и материал модели
properties-reset = { $name }: автоматически
    .tooltip = Забыть это значение: оно снова будет следовать из остальных

properties-made-of = Сделано из
    .tooltip = Материал предмета; у нескольких предметов он может быть общим
properties-new-material = Новый материал
properties-new-material-name = материал
properties-give-material = Дать материал
    .tooltip = Создать для предмета новый материал
properties-no-material = Без материала предмет светло-серый; модель сохраняет свои материалы.
properties-shared = { $count ->
    [one] Из этого сделан { $count } предмет; изменится и он.
    [few] Из этого сделаны { $count } предмета; изменятся все.
   *[other] Из этого сделано { $count } предметов; изменятся все.
}
properties-own-copy = Сделать свою копию
    .tooltip = Дать предмету собственный материал, чтобы остальные не изменились
properties-more = Ещё
properties-more-remark = Физические величины с именами OpenPBR. Отмеченное «авто» следует из остального.
properties-inside = Внутри
properties-coat = Покрытие
properties-film = Тонкая плёнка
properties-glow = Свечение
properties-patterns = Узоры и рельеф
properties-pattern = Узор
properties-new-pattern-name = узор

properties-aim = Наводка
    .tooltip = Навести камеру на точку или повернуть на углы
properties-aim-point = на точку
properties-aim-turn = поворотом
properties-lens = Объектив
properties-blur = Размывать вне фокуса
    .tooltip = Размывать то, что ближе или дальше фокуса, как на фотографии. Только в фотореалистичных картинках
properties-turn-by = Повернуть на угол
properties-angle = Угол
    .tooltip = На сколько градусов повернуть; положительный угол — против часовой стрелки, если смотреть с конца оси
properties-axis = Ось { $axis }
    .tooltip = Поворот вокруг оси { $axis } мира, проходящей через камеру
properties-turn = Повернуть
    .tooltip = Повернуть камеру на этот угол вокруг этой оси
properties-look = В кадре
properties-look-at = Смотреть на
    .tooltip = Навести камеру на центр предмета
properties-frame-all = Показать всё
    .tooltip = Отойти или приблизиться, чтобы на картинке было всё

properties-scene = Сцена
properties-nothing-selected = Ничего не выбрано. Щёлкните предмет на картинке или в списке, чтобы увидеть его свойства.
properties-about = О сцене
    .tooltip = Что показывает сцена, одной строкой
properties-picture = Картинка
