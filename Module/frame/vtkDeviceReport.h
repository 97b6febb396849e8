/**
 * @class   vtkDeviceReport
 * @brief   what Vitrine does on a device, as a text to paste into a bug report
 *
 * The text has VTK's version, what OpenGL tells of the device, and for each method and each pass for many lights whether it
 * works there, or why not.
 *
 * \code
 * vtkNew<vtkRenderWindow> window;
 * window->SetOffScreenRendering(true);
 * cout << vtkDeviceReport::Describe(window);
 * \endcode
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
  static vtkDeviceReport* New();
  vtkTypeMacro(vtkDeviceReport, vtkObject);

  /**
   * Draws a few small frames in `window`, which should hold nothing else, and says what came of them. The window is
   * empty afterwards. Returns a text of several lines; one line says so where the window has no OpenGL.
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
