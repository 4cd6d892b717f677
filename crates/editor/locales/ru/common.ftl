## Words used everywhere.
