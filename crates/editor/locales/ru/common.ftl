## Words used everywhere.

common-cancel = Отмена
