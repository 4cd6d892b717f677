## Opening, saving and recovering.
