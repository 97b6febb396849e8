/**
 * Which opaque parts a perfect culler would draw: those that own a pixel.
 *
 * H. Weghorst, G. Hooper, D. P. Greenberg: Improved computational methods for ray tracing, ACM TOG 3(1), 1984 (item buffer).
 */
#ifndef VITRINE_PROGRAM_ITEM_BUFFER_H
#define VITRINE_PROGRAM_ITEM_BUFFER_H

#include "methods/Stage.h"
#include "scene/Scene.h"

#include "vtkCamera.h"

namespace program
{

class ItemBuffer
{
public:
  /** All opaque polygons of the scene as one mesh, in colours that number the parts. */
  ItemBuffer(const Scene& scene, PictureSize size);

  /** How many parts own a pixel. */
  std::size_t CountOwners(vtkCamera* camera);

  /** How many parts there are in it. */
  std::size_t CountParts() const { return this->Parts; }

private:
  std::size_t Parts = 0;
  Scene Numbered;
  Stage Window;
};

}

#endif
