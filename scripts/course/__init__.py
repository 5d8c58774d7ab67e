"""The coursework of Raysteps: see docs/course.md."""
