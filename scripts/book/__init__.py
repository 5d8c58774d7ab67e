"""Makes the book of Raysteps: see docs/book."""
