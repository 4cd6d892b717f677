## Labels and tooltips of parameters. English tooltips come from the descriptions in the code.
