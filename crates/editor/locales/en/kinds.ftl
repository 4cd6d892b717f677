## Names of kinds and of choices.
