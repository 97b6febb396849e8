"""What the tests of behave.py and inspection.py have in common."""

import scenes
from paraview import servermanager
from paraview.simple import CreateView, Render, ResetCamera
from pictures import SIZE, difference, layers_of, picture

TESTS = {}


def test(by, allowed):
    """A function that returns the difference, which is judged by something."""

    def take(function):
        TESTS[function.__name__.replace("_", " ")] = function, by, allowed
        return function

    return take


def new_view(kind="VitrineRenderView", size=SIZE):
    view = CreateView(kind)
    view.ViewSize = size
    view.UseFXAA = 0
    return view


def glass(view, count=8):
    scenes.spheres(view, count, 0.2)
    ResetCamera(view)
    Render(view)


def off_truth(view, path, change=lambda pixels: pixels, **options):
    """The difference of a view's picture to truth's, with a change to both."""
    drawn = picture(view, path, **options)
    is_panel = view.GetXMLName() == "VitrineRenderView"
    layers_of(view if is_panel else servermanager._getPyProxy(view.SMProxy.GetRootView()))
    method, view.TransparencyMethod = view.TransparencyMethod, "truth"
    right = picture(view, path, **options)
    view.TransparencyMethod = method
    return difference(change(drawn), change(right))
