// A translucent sphere around an opaque one in a window of Qt, seen through exactly, with a slider for its opacity. If
// a file is named, the window's picture is written there, and the program ends. The lines that make the difference
// are marked.
#include "vtkActor.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h" // (1)
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <QApplication>
#include <QSlider>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <string>

namespace
{
vtkSmartPointer<vtkActor> MakeSphere(double radius, double red, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, 0.4, 1.0 - red);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

/** Returns 0, or 1 if the pass could not draw or the picture cannot be written. */
int Save(vtkRenderWindow* window, vtkSeeThroughPass* seeThrough, const char* file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  const bool isExact = std::string(seeThrough->GetFallbackReason()).empty();
  return writer->GetErrorCode() == 0 && isExact ? 0 : 1;
}
}

int main(int argc, char* argv[])
{
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setVersion(4, 3); // (2) what the fast methods need
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(MakeSphere(0.5, 1.0, 1.0));
  const vtkSmartPointer<vtkActor> shell = MakeSphere(1.0, 0.0, 0.3);
  renderer->AddActor(shell);
  vtkNew<vtkSeeThroughPass> seeThrough; // (3)
  renderer->SetPass(seeThrough);        // (4)

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->AddRenderer(renderer);
  QWidget main;
  auto* const view = new QVTKOpenGLNativeWidget(window, &main);
  view->setMinimumSize(400, 300);
  auto* const opacity = new QSlider(Qt::Horizontal, &main);
  opacity->setRange(0, 100);
  opacity->setValue(30);
  QObject::connect(opacity, &QSlider::valueChanged,
    [&](int percent)
    {
      shell->GetProperty()->SetOpacity(percent / 100.0);
      window->Render();
    });
  auto* const layout = new QVBoxLayout(&main);
  layout->addWidget(view);
  layout->addWidget(opacity);
  main.show();

  if (argc > 1)
  {
    // After the first frame, which Qt draws when the window is there.
    QTimer::singleShot(0, [&] { QApplication::exit(Save(window, seeThrough, argv[argc - 1])); });
  }
  return QApplication::exec();
}
