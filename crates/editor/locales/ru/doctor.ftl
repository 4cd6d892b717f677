# Почему картинка чёрная, белая или пустая.
doctor-no-light = Картинка чёрная, потому что нет ни одного источника света
doctor-lights-off = Картинка чёрная, потому что все источники света выключены
doctor-lights-zero = Картинка чёрная, потому что интенсивность всех источников равна нулю
doctor-too-dark = Картинка тёмная, потому что источники света очень слабые
doctor-too-bright = Картинка белая, потому что источники света вместе слишком яркие
doctor-no-object = Картинка пустая, потому что в сцене ничего нет
doctor-all-hidden = Картинка пустая, потому что всё скрыто
doctor-camera-inside = Камера внутри «{ $name }»
doctor-camera-under = Камера под «{ $name }»
doctor-all-behind = Всё находится позади камеры
doctor-nothing-in-view = В поле зрения камеры ничего нет
doctor-camera-too-far = Камера так далеко, что ничего не разглядеть
doctor-camera-too-near = Камера слишком близко к «{ $name }»

# Чем это исправить.
doctor-mend-add-lamp = Добавить лампу
doctor-mend-switch-on = Включить свет
doctor-mend-brighten = Сделать свет ярче
doctor-mend-dim = Приглушить свет
doctor-mend-add-ball = Добавить шар
doctor-mend-show-all = Показать всё
doctor-mend-step-out = Выйти наружу
doctor-mend-step-up = Подняться выше
doctor-mend-step-back = Отойти назад
doctor-mend-frame-all = Показать всё в кадре

# Прочие замечания.
problem-missing-picture = Нет картинки { $path }
problem-missing-model = Нет модели { $path }
problem-open-model = Модель «{ $name }» прозрачная и с дырами, поэтому не похожа на стекло
problem-equal-solids = «{ $name }» и «{ $other }» из разного стекла, пересекаются и одинаковы по объёму, поэтому в общей части один из них взят случайно
problem-asset = { $text }
