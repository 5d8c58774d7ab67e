"""The bars of one number up to this chapter."""

from drawings.speed import HEIGHT, alt, draw_up_to  # HEIGHT is read by the catalogue

CHAPTER = "10"
ALT = alt(CHAPTER)
SENTENCES = []


def draw(canvas, lesson):
    draw_up_to(CHAPTER, canvas, lesson)
