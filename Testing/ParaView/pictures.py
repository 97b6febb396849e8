"""Pictures of views, for the tests of the plugin for ParaView."""

import numpy
from paraview.simple import ClearSelection, Delete, GetColorTransferFunction, GetSources, SaveScreenshot
from PIL import Image

SIZE = [240, 200]


def read(path):
    return numpy.asarray(Image.open(path)).astype(int)


def picture(view, path, **options):
    """The picture of a view or layout, as integers by rows, columns and channels."""
    options.setdefault("ImageResolution", SIZE)
    SaveScreenshot(str(path), view, **options)
    return read(path)


def layers_of(view):
    """The most layers of a pixel of the view's last picture. It is an error if it was not drawn exactly."""
    view.UpdatePropertyInformation()
    reason, layers = (view.GetProperty(name)[0] for name in ("FallbackReason", "MaximumNumberOfLayers"))
    if reason or not layers:
        raise AssertionError(f"not drawn exactly: {reason or 'there are no layers'}")
    return int(layers)


def difference(one, other):
    """The most levels of 255 by which a channel of two pictures differs."""
    if one.shape != other.shape:
        raise AssertionError(f"pictures of {one.shape} and {other.shape} pixels")
    return float(abs(one - other).max())


def delete_all(*views):
    """Delete all sources, and these views."""
    for source in GetSources().values():
        ClearSelection(source)
        Delete(source)
    for view in views:
        Delete(view)
    GetColorTransferFunction("RTData").EnableOpacityMapping = 0
