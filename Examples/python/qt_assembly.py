#!/usr/bin/env python3
"""
A gearbox in a window of Qt
===========================

Look through the housing of a gearbox in a window of PySide6, by pyvistaqt, with a slider for the housing's opacity.

``qt_assembly.py [PICTURE.png]`` opens the window. If a file is named, the window's picture is written there, and the
program ends. It needs ``pip install PySide6-Essentials pyvistaqt``.
"""

import sys

import pyvista
from PySide6 import QtCore, QtWidgets
from pyvista_assembly import gearbox
from pyvistaqt import QtInteractor

import vitrine


class Window(QtWidgets.QWidget):
    def __init__(self):
        super().__init__()
        self.view = QtInteractor(self, auto_update=False)
        blocks, looks = gearbox()
        for name, (color, opacity) in looks.items():
            self.view.add_mesh(blocks[name], name=name, color=color, opacity=opacity, smooth_shading=False)
        vitrine.see_through(self.view)

        slider = QtWidgets.QSlider(QtCore.Qt.Orientation.Horizontal)
        slider.setRange(0, 100)
        slider.setValue(25)
        slider.valueChanged.connect(self.set_opacity)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.view)
        layout.addWidget(slider)
        self.resize(500, 420)

    def set_opacity(self, percent):
        self.view.actors["housing"].prop.opacity = percent / 100
        self.view.render()

    def closeEvent(self, event):
        self.view.close()  # while its window is there
        super().closeEvent(event)


def main():
    application = QtWidgets.QApplication(sys.argv)
    window = Window()
    window.show()
    if len(sys.argv) > 1:

        def save():
            window.view.screenshot(sys.argv[1])
            window.close()

        QtCore.QTimer.singleShot(0, save)
    sys.exit(application.exec())


if __name__ == "__main__":
    main()

# sphinx_gallery_thumbnail_path = "images/thumbnails/pyvista-assembly.png"
