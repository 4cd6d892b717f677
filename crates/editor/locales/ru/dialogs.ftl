## Dialogs.
