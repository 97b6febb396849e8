"""PyVista's plotters in notebooks: what a kernel sends with each backend, and the warning where the browser draws."""

import base64
import io
import re
import unittest
import warnings
import weakref

import nbclient
import nbformat
import numpy
import pyvista
from PIL import Image

import vitrine

BROWSER = "the browser draws this view by itself"
EITHER = "while the browser draws this view"
CELL = """
plotter = pyvista.Plotter(window_size=(120, 90))
for radius in (1.0, 0.8, 0.6, 0.4):
    plotter.add_mesh(pyvista.Sphere(radius=radius), color="gold", opacity=0.35)
plotter.vitrine.see_through("{method}")
plotter.show({show})
"""


def shells():
    plotter = pyvista.Plotter(off_screen=True, notebook=True, window_size=(120, 90))
    plotter.add_mesh(pyvista.Sphere(), opacity=0.35)
    return plotter


class View:
    """Stands for a view of trame-pyvista, which adds a callback like this."""

    def __init__(self, plotter):
        self._callback = lambda *_: self.update()
        plotter.add_on_render_callback(self._callback, render_event=False)

    def update(self):
        pass


class PyVistaLocalView(View):
    pass


class PyVistaRemoteView(View):
    pass


class Kernel(unittest.TestCase):
    """One kernel runs a cell for each backend, as a notebook would, without a browser."""

    @classmethod
    def setUpClass(cls):
        cells = {
            "truth": CELL.format(method="truth", show="jupyter_backend='static'"),
            "static": CELL.format(method="linked-list", show="jupyter_backend='static'"),
        }
        for mode in ("server", "client", "trame"):
            show = f"jupyter_backend='{mode}', jupyter_kwargs={{'mode': '{mode}'}}"
            cells[mode] = CELL.format(method="linked-list", show=show)
        cells["html"] = CELL.format(method="linked-list", show="jupyter_backend='html'")
        setup = "import pyvista\npyvista.OFF_SCREEN = True"
        notebook = nbformat.v4.new_notebook()
        notebook.cells = [nbformat.v4.new_code_cell(cell) for cell in (setup, *cells.values())]
        nbclient.NotebookClient(notebook, timeout=120).execute()
        cls.outputs = {name: cell.outputs for name, cell in zip(cells, notebook.cells[1:])}

    def warnings_of(self, name):
        return "".join(output.text for output in self.outputs[name] if output.get("name") == "stderr")

    def data_of(self, name):
        return [output.data for output in self.outputs[name] if output.output_type == "display_data"]

    def picture_of(self, name):
        png = next(data["image/png"] for data in self.data_of(name) if "image/png" in data)
        return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(png)))).astype(int)

    def test_sends_exact_pictures_where_python_draws_once(self):
        truth, ours = self.picture_of("truth"), self.picture_of("static")
        self.assertLessEqual(abs(truth - ours).max(), 1)
        self.assertGreater(len(numpy.unique(ours.reshape(-1, 3), axis=0)), 20)

    def test_sends_a_page_for_other_backends(self):
        for name in ("server", "client", "trame", "html"):
            self.assertIn("iframe", str(self.data_of(name)), name)

    def test_warns_once_where_the_browser_draws(self):
        for name, text in (("client", BROWSER), ("html", BROWSER), ("trame", EITHER)):
            self.assertEqual(len(re.findall(text, self.warnings_of(name))), 1, name)
            self.assertIn("jupyter_backend='server'", self.warnings_of(name))
        for name in ("static", "server"):
            self.assertNotIn("see_through()", self.warnings_of(name))


class Warnings(unittest.TestCase):
    def tearDown(self):
        pyvista.close_all()

    def told(self, action, *arguments):
        """The warnings of Vitrine that an action gives, and the files that they name."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            action(*arguments)
        return [(each.filename, str(each.message)) for each in caught if "see_through()" in str(each.message)]

    def test_name_the_line_that_exports(self):
        plotter = shells()
        vitrine.see_through(plotter)
        ((file, text),) = self.told(plotter.trame.export_html, None)
        self.assertEqual(file, __file__)
        self.assertIn(BROWSER, text)
        self.assertEqual(self.told(plotter.trame.export_vtksz, None), [])

    def test_are_of_plotters_that_are_see_through(self):
        plotter, other = shells(), shells()
        inner, outer = vitrine.see_through(plotter), vitrine.see_through(plotter, "linked-list")
        self.assertEqual(self.told(PyVistaLocalView, other), [])
        inner.remove()
        self.assertEqual(self.told(PyVistaRemoteView, plotter), [])
        self.assertEqual(len(self.told(PyVistaLocalView, plotter)), 1)
        outer.remove()
        outer.remove()
        self.assertNotIn("add_on_render_callback", vars(plotter))
        self.assertEqual(self.told(PyVistaLocalView, plotter), [])

    def test_are_of_views_that_are_there_before(self):
        plotter = shells()
        views = [PyVistaLocalView(plotter)]
        self.assertEqual(len(self.told(vitrine.see_through, plotter)), 1)
        self.assertEqual(self.told(vitrine.see_through, plotter), [])
        del views

    def test_leave_callbacks_as_they_are(self):
        plotter = shells()
        vitrine.see_through(plotter)
        called = []
        plotter.add_on_render_callback(called.append, render_event=False)
        plotter.show(auto_close=False, jupyter_backend="none")
        self.assertEqual(set(map(id, called)), {id(plotter)})

    def test_keep_no_plotter(self):
        plotter = shells()
        vitrine.see_through(plotter)
        plotter.close()
        gone = weakref.ref(plotter)
        del plotter
        pyvista.close_all()
        self.assertIsNone(gone())


if __name__ == "__main__":
    unittest.main()
