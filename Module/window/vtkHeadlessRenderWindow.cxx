#include "vtkHeadlessRenderWindow.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeadlessRenderWindow);

vtkHeadlessRenderWindow::vtkHeadlessRenderWindow() = default;
vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow() = default;
