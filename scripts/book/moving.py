"""Drawings that move: the page has the still picture, and names the script that has the moments."""

import json

from drawings.catalogue import make


def moving_script(path, name):
    """What the file `name` of the book has: the moments of the drawing; nothing where it stands still."""
    drawing = make(path)
    if not drawing.moments:
        return ""
    still = drawing.moving_svg.count("class='moment", 0, drawing.moving_svg.index("class='moment shown'"))
    return (
        f"window.drawingMoments[{json.dumps(name)}] = "
        f"{json.dumps({'svg': drawing.moving_svg, 'words': drawing.moments, 'still': still})};\n"
    )
