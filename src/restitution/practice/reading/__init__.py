"""What a student types, read: text → characters → tokens → segments → claims in every reading."""
