## Words used everywhere.

common-cancel = Cancel
