#ifndef VITRINE_SCENE_VISIBLE_BOX_H
#define VITRINE_SCENE_VISIBLE_BOX_H

#include "Core/geometry/Box.h"
#include "scene/PipelineState.h"

#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkDataSetMapper;
class vtkMapper;
class vtkPolyDataMapper;
class vtkProp;
class vtkRenderer;
class vtkShaderProperty;
class vtkTrivialProducer;

namespace vitrine
{

/**
 * Finds the box around all visible props of a renderer. It keeps the boxes of the props from frame to frame, and asks
 * VTK anew only for props that have changed by their modification times: VTK's bounds update pipelines.
 */
class VisibleBox
{
public:
  /**
   * Returns the box, in world coordinates (WC), around all visible props, including culled ones. It is absent if a prop
   * may be drawn outside its bounds.
   */
  std::optional<Box> Find(vtkRenderer* renderer);

private:
  /**
   * An actor when its box was last read. The objects behind pointers exist as long as the times of their holders have
   * not changed.
   */
  struct Known
  {
    vtkProp* Prop = nullptr;
    vtkMTimeType PropTime = 0; ///< 0 if it must be read in each frame
    vtkShaderProperty* Shader = nullptr;
    vtkMTimeType ShaderTime = 0;
    vtkMapper* Mapper = nullptr;
    vtkMTimeType MapperTime = 0;
    vtkDataSetMapper* SurfaceMapper = nullptr; ///< the mapper, if another one draws for it
    vtkTrivialProducer* Producer = nullptr;    ///< null if filters make the data (Pipeline)
    vtkMTimeType ProducerTime = 0;
    vtkDataObject* Data = nullptr;
    vtkMTimeType DataTime = 0;
    PipelineState Pipeline;
    std::optional<Box> InWorld; ///< absent if nothing of it is drawn
  };

  void PutInOrder(vtkRenderer* renderer);
  static bool IsUnchanged(const Known& known);
  static bool AreDataUnchanged(const Known& known);
  static bool Read(Known& known);
  static void NoteTimes(Known& known, vtkActor* actor);
  void Prefetch(std::size_t i) const;

  std::vector<Known> All; ///< all props of the renderer, in its order
};

/** Returns the prop's bounds. They are absent if nothing of it is drawn, or nothing in world coordinates. */
std::optional<Box> BoxAround(vtkProp* prop);

}

#endif
