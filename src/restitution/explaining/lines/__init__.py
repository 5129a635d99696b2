"""Lines as data: trees, relations, derivations, their sentences, and how they are stored."""
