## Materials and templates.
