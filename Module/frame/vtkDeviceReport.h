/**
 * @class   vtkDeviceReport
 * @brief   report on what this module can do on a device
 *
 * The report is a text for a bug report. It contains VTK's version, the properties of the OpenGL device, and for each
 * transparency method and each lights pass whether it works there, or why not.
 *
 * @code
 * vtkNew<vtkRenderWindow> window;
 * window->SetOffScreenRendering(true);
 * cout << vtkDeviceReport::Describe(window);
 * @endcode
 *
 * @sa
 * vtkTransparencyPass vtkClusteredLightsPass vtkHeadlessRenderWindow
 */
#ifndef vtkDeviceReport_h
#define vtkDeviceReport_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <string> // for the text

class vtkRenderWindow;

class VTKVITRINERENDERING_EXPORT vtkDeviceReport : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkDeviceReport* New();
  vtkTypeMacro(vtkDeviceReport, vtkObject);
  ///@}

  /**
   * Draw a few frames of 64 x 48 pixels in a window, and get the report. The window should contain nothing else. It is
   * resized, and it is empty afterwards. The text has several lines. If the window is null or has no OpenGL context, a
   * line of the text says so and no frames are described.
   */
  static std::string Describe(vtkRenderWindow* window);

protected:
  vtkDeviceReport() = default;
  ~vtkDeviceReport() override = default;

private:
  vtkDeviceReport(const vtkDeviceReport&) = delete;
  void operator=(const vtkDeviceReport&) = delete;
};

#endif
