"""Write the pages that are made from the code: C++ classes, Python's functions, the program's help, examples.

    generate_reference.py SOURCE    the copy of docs/ that Sphinx reads (scripts/docs)

`vitrine` is on PATH, and VITRINE_CLASSES names the public classes.
"""

import os
import pathlib
import re
import subprocess
import sys
from xml.etree import ElementTree

from PIL import Image

# Classes without New(), whose protected functions a new method needs.
BASE_CLASSES = ("vtkTransparencyPass", "vtkTolerantTransparencyPass", "vtkABufferTransparencyPass")


def write(page, text):
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(text, encoding="utf-8")


def append(page, text):
    write(page, page.read_text(encoding="utf-8") + text)


def toctree(entries):
    return "\n```{toctree}\n:hidden:\n:maxdepth: 1\n\n" + "\n".join(entries) + "\n```\n"


def help_of(*command):
    return subprocess.run(["vitrine", *command, "--help"], capture_output=True, text=True, check=True).stdout


def commands():
    """The names of the program's commands, as its help lists them."""
    lines = help_of().split("Subcommands:\n", 1)[1].splitlines()
    return [line.split()[0] for line in lines[: lines.index("")]]


def merge_groups(xml):
    """Make of groups without a name, by which getters and setters share a text, a part of the other functions."""
    for file in xml.glob("class*.xml"):
        tree = ElementTree.parse(file)
        described = tree.find("compounddef")
        kinds = ("user-defined", "public-func")
        sections = [section for section in described.findall("sectiondef") if section.get("kind") in kinds]
        for section in sections[1:]:
            sections[0].extend(section.findall("memberdef"))
            described.remove(section)
        sections[0].set("kind", "public-func")
        tree.write(file, encoding="utf-8", xml_declaration=True)


def add_cpp(source):
    """A page of each public class, below reference/cpp.md."""
    merge_groups(pathlib.Path(os.environ["VITRINE_DOXYGEN"]))
    classes = os.environ["VITRINE_CLASSES"].split()
    for name in classes:
        options = ":members:"
        if name in BASE_CLASSES:
            options += "\n:protected-members:"
        body = f"# {name}\n\n```{{doxygenclass}} {name}\n{options}\n```\n"
        write(source / "reference/cpp" / f"{name}.md", body)
    append(source / "reference/cpp.md", toctree(f"cpp/{name}" for name in classes))


def add_python(source):
    """The functions of the package, behind reference/python.md."""
    text = "\n## All functions\n\n```{eval-rst}\n"
    for directive in (
        ".. autofunction:: vitrine.load",
        ".. autofunction:: vitrine.from_multiblock",
        *(f".. autoclass:: vitrine.{name}\n   :members:" for name in ("Assembly", "Selection", "Part", "Tree")),
        ".. autofunction:: vitrine.see_through",
        ".. autoclass:: vitrine.SeeThrough\n   :members:",
        ".. autofunction:: vitrine.stats",
        ".. autoclass:: vitrine.Stats\n   :members:",
        ".. autofunction:: vitrine.report",
        ".. autofunction:: vitrine.testing.assert_image",
    ):
        text += f".. currentmodule:: vitrine\n\n{directive}\n\n"
    append(source / "reference/python.md", text + "```\n")


def add_program(source):
    """The help of each command, behind reference/program.md."""
    text = "\n## Options of each command\n"
    for command in commands():
        usage = re.split(r"\nINPUT is a file", help_of(command))[0].rstrip()
        text += f"\n### vitrine {command}\n\n```text\n{usage}\n```\n"
    append(source / "reference/program.md", text)


def crop_last(row, file):
    """Write the last of three pictures that stand in a row."""
    file.parent.mkdir(exist_ok=True)
    with Image.open(row) as whole:
        whole.crop((2 * whole.width // 3, 0, whole.width, whole.height)).save(file)


def add_examples(source):
    """The gallery below examples.md. Its scripts are a copy of Examples/python beside the source."""
    scripts = source.parent / "examples"
    write(scripts / "GALLERY_HEADER.rst", "Examples\n========\n")  # Sphinx-Gallery asks for one
    page = source / "examples.md"
    text = re.sub(r"\(\.\./Examples/python/(\w+)\.py\)", r"(examples/\1.rst)", page.read_text(encoding="utf-8"))
    write(page, text)
    for picture in (source / "images").glob("pyvista-*.png"):
        crop_last(picture, picture.parent / "thumbnails" / picture.name)
    append(page, "\n```{eval-rst}\n.. minigallery:: ../examples/see_through.py ../examples/pyvista_*.py\n```\n")
    append(page, toctree(re.findall(r"\((examples/\w+)\.rst\)", text)))


def main():
    source = pathlib.Path(sys.argv[1])
    add_cpp(source)
    add_python(source)
    add_program(source)
    add_examples(source)


if __name__ == "__main__":
    main()
