/**
 * Finds the opaque parts that a perfect culler would draw: those that own a pixel.
 *
 * H. Weghorst, G. Hooper, D. P. Greenberg: Improved computational methods for ray tracing, ACM TOG 3(1), 1984 (item
 * buffer).
 */
#ifndef VITRINE_PROGRAM_ITEM_BUFFER_H
#define VITRINE_PROGRAM_ITEM_BUFFER_H

#include "methods/Stage.h"
#include "scene/Scene.h"

#include "vtkCamera.h"

#include <cstddef>
#include <vector>

namespace program
{

class ItemBuffer
{
public:
  /** All opaque polygons of the scene as one mesh, in colours that number the parts. */
  ItemBuffer(const Scene& scene, PictureSize size);

  /** The parts that own a pixel, as they count in the scene. */
  std::vector<std::size_t> FindOwners(vtkCamera* camera);

  /** The parts that are in it. */
  const std::vector<std::size_t>& Parts() const { return this->Opaque; }

private:
  std::vector<std::size_t> Opaque;
  Scene Numbered;
  Stage Window;
};

}

#endif
