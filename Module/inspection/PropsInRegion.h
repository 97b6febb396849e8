/** Finds the props that may be drawn in a rectangle of pixels. */
#ifndef VITRINE_INSPECTION_PROPS_IN_REGION_H
#define VITRINE_INSPECTION_PROPS_IN_REGION_H

#include "Core/geometry/Box.h"
#include "Core/geometry/PixelRegion.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

class vtkActor;
class vtkDataObject;
class vtkMapper;
class vtkProp;
class vtkRenderer;
class vtkShaderProperty;

namespace vitrine
{

/**
 * Finds props by boxes around the data that they were last drawn with. It keeps the boxes, since VTK's bounds update
 * pipelines, which takes longer than to draw a few pixels. Actors are looked at each time, and their data after each
 * frame of the renderer.
 */
class PropsInRegion
{
public:
  PropsInRegion() = default;
  ~PropsInRegion() { this->Watch(nullptr); }
  PropsInRegion(const PropsInRegion&) = delete;
  void operator=(const PropsInRegion&) = delete;

  /**
   * Returns the visible props of the renderer that may be drawn within a rectangle of the window's pixels, in their
   * order: those whose boxes meet the pyramid of the rectangle, with a margin for wide lines and points, and those that
   * may be drawn outside of their data. Props of the overlay, and volumes, are left out.
   * @param onlyOpaque  leave out actors that had no opaque geometry since they changed, or since the last frame
   */
  std::vector<vtkProp*> Find(vtkRenderer* renderer, const PixelRegion& region, bool onlyOpaque);

private:
  /** An actor when its box was read. Times of VTK never come again, so they tell also of other objects in its place. */
  struct Known
  {
    vtkMTimeType ActorTime = 0;
    vtkMapper* Mapper = nullptr;
    vtkMTimeType MapperTime = 0;
    vtkShaderProperty* Shader = nullptr;
    vtkMTimeType ShaderTime = 0;
    vtkDataObject* Data = nullptr;
    vtkMTimeType DataTime = 0;
    std::uint64_t Frame = 0; ///< when the time of the data was read
    bool HasOpaque = true;
    bool IsAnywhere = false;    ///< It may be drawn outside of its data.
    std::optional<Box> InWorld; ///< absent if it has no data

    bool operator==(const Known& other) const;
  };

  void Watch(vtkRenderer* renderer);
  void NoteFrame() { ++this->Frame; }
  const Known& Look(vtkActor* actor);

  std::unordered_map<vtkProp*, Known> Boxes;
  vtkWeakPointer<vtkRenderer> Watched;
  unsigned long Observer = 0;
  std::uint64_t Frame = 1; ///< counts the frames of the renderer
};

}

#endif
