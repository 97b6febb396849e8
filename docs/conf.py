"""The site of Vitrine, by Sphinx. scripts/docs copies docs/ to build/docs/source, adds the generated pages and builds it."""

import os
import posixpath
import re
import sys

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms.post_transforms import SphinxPostTransform

sys.path.append(os.path.dirname(__file__))  # gallery_pictures

project = "Vitrine"
author = "the authors of Vitrine"
release = os.environ["VITRINE_VERSION"]
version = release

extensions = [
    "breathe",
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["lab/moved.md", "examples/index.rst"]  # examples.md is the gallery's page
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
suppress_warnings = [
    "myst.xref_missing",  # docs/check_pages.py follows all links
    "toc.not_included",  # lab/ is not in the menu
]

breathe_projects = {"vitrine": os.environ["VITRINE_DOXYGEN"]}
breathe_default_project = "vitrine"
breathe_default_members = ("members",)
autodoc_member_order = "bysource"
autodoc_typehints = "description"

sphinx_gallery_conf = {
    "examples_dirs": "../examples",
    "gallery_dirs": "examples",
    "backreferences_dir": "examples/backreferences",
    "filename_pattern": "see_through",  # others need PyVista, which needs a later VTK than Debian's
    "image_scrapers": ("gallery_pictures.take_pictures",),
    "reset_modules": (),
    "download_all_examples": False,
    "notebook_extensions": set(),  # in a notebook sys.argv is Jupyter's
    "remove_config_comments": True,
    "show_signature": False,
    "write_computation_times": False,
    "min_reported_time": 60,
}

html_theme = "furo"
html_title = f"Vitrine {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False

VTK_CLASS = re.compile(r"\bvtk[A-Z]\w+")
GONE_CLASSES = ("vtkCompositePolyDataMapper2",)  # VTK 9.6 has it no more, and its documentation neither
OWN_CLASSES = set(os.environ["VITRINE_CLASSES"].split())


class LinkClasses(SphinxPostTransform):
    """Links names of classes that stand in code type, and those in the text of headers, which has no code type.

    Vitrine's are linked to their own page, VTK's to VTK's documentation. vtk-xref would need a role at each name, which
    forges do not know, and asks vtk.org for each class at build time.
    """

    default_priority = 5

    def run(self, **kwargs):
        for literal in list(self.document.findall(nodes.literal)):
            if VTK_CLASS.fullmatch(literal.astext()) and not isinstance(literal.parent, nodes.reference):
                literal.replace_self(self.linked(literal.astext(), literal))
        if self.env.current_document.docname.startswith("reference/cpp/"):
            for text in list(self.document.findall(nodes.Text)):
                if isinstance(text.parent, nodes.paragraph):
                    text.parent.replace(text, list(self.parts(text.astext())))

    def parts(self, text):
        end = 0
        for name in VTK_CLASS.finditer(text):
            yield nodes.Text(text[end : name.start()])
            yield self.linked(name.group(), nodes.Text(name.group()))
            end = name.end()
        yield nodes.Text(text[end:])

    def linked(self, name, shown):
        if name in GONE_CLASSES:
            return shown
        address = f"https://vtk.org/doc/nightly/html/class{name}.html"
        if name in OWN_CLASSES:
            page = f"reference/cpp/{name}"
            if page == self.env.current_document.docname:
                return shown
            address = self.app.builder.get_relative_uri(self.env.current_document.docname, page)
        link = nodes.reference("", "", internal=name in OWN_CLASSES, refuri=address)
        link += shown.deepcopy()
        return link


class UnlinkFilesBesideDocs(SphinxPostTransform):
    """Makes plain text of links to files of the repository that are not below docs/, since the site does not have them."""

    default_priority = 8  # MyST resolves links at 9

    def run(self, **kwargs):
        folder = posixpath.dirname(self.env.current_document.docname)
        for link in list(self.document.findall(addnodes.pending_xref)):
            path = link["reftarget"].partition("#")[0]
            if link["reftype"] == "myst" and posixpath.normpath(posixpath.join(folder, path)).startswith("../"):
                link.replace_self(link[0].children)


def setup(app):
    app.add_post_transform(LinkClasses)
    app.add_post_transform(UnlinkFilesBesideDocs)
