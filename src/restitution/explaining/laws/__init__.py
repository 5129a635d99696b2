"""The laws, definitions and identities as records."""
