## The glossary.
