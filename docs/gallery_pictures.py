"""Takes the pictures that a script of the gallery has written, for Sphinx-Gallery (docs/conf.py)."""

import pathlib
import shutil

from sphinx_gallery.scrapers import figure_rst


def take_pictures(block, block_vars, gallery_conf):
    """Move the PNG files beside the script to the gallery, and return the text that shows them."""
    taken = []
    for picture in sorted(pathlib.Path(block_vars["src_file"]).parent.glob("*.png")):
        taken.append(block_vars["image_path_iterator"].next())
        shutil.move(picture, taken[-1])
    return figure_rst(taken, gallery_conf["src_dir"])
