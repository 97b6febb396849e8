/**
 * @class   vtkLightPresets
 * @brief   lights that suit most scenes, by name
 *
 * "headlight" is the light that VTK makes at the camera. "studio" has five lights that move with the camera. "side" has
 * a strong one at the upper left of the camera, and "above" one that stays above the scene, in the direction
 * (0.3, 1, 0.2). Both have a weak one at the camera besides.
 *
 * @code
 * vtkLightPresets::Apply(renderer, "studio");
 * @endcode
 *
 * @sa
 * vtkClusteredLightsPass vtkRenderer::SetAutomaticLightCreation()
 */
#ifndef vtkLightPresets_h
#define vtkLightPresets_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkLightPresets : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkLightPresets* New();
  vtkTypeMacro(vtkLightPresets, vtkObject);
  ///@}

  ///@{
  /**
   * Get how many presets there are, and their names. The first one is "headlight". The name is null if there is no such
   * index.
   */
  static int GetNumberOfPresets();
  static const char* GetName(int index);
  ///@}

  /**
   * Light a renderer by a preset in place of its lights. Returns false, and changes nothing, if the renderer is null or
   * there is no preset of this name.
   */
  static bool Apply(vtkRenderer* renderer, const char* name);

protected:
  vtkLightPresets() = default;
  ~vtkLightPresets() override = default;

private:
  vtkLightPresets(const vtkLightPresets&) = delete;
  void operator=(const vtkLightPresets&) = delete;
};

#endif
