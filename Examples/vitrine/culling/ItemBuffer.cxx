#include "culling/ItemBuffer.h"

#include "culling/MergedMesh.h"
#include "methods/VTKMethods.h"
#include "scene/files/GeometryCheck.h"

#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <set>

namespace program
{

namespace
{

/**
 * Gives opaque parts numbers from 1; the background has none. If a point is not finite, no part gets a number, since
 * such a point spoils the drawing of all parts in the same buffer.
 */
Scene NumberParts(const Scene& scene, std::vector<std::size_t>& opaque)
{
  MergedMesh mesh;
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    const Part& part = scene.Parts[i];
    if (!IsTranslucent(part) && part.Geometry->GetNumberOfPolys() > 0)
    {
      opaque.push_back(i);
      const std::size_t count = opaque.size();
      mesh.Add(part,
        { static_cast<unsigned char>(count >> 16), static_cast<unsigned char>(count >> 8),
          static_cast<unsigned char>(count) });
    }
  }
  Scene numbered;
  numbered.Placement = scene.Placement;
  Part all;
  all.Geometry = mesh.Mesh();
  all.Material = vtkSmartPointer<vtkProperty>::New();
  all.Material->LightingOff();
  if (!HasFinitePoints(all.Geometry))
  {
    opaque.clear();
  }
  numbered.Parts.push_back(all);
  return numbered;
}
}

ItemBuffer::ItemBuffer(const Scene& scene, PictureSize size)
  : Numbered(NumberParts(scene, this->Opaque))
  , Window(this->Numbered, MakeVTKOIT(), size, 0)
{
}

std::vector<std::size_t> ItemBuffer::FindOwners(vtkCamera* camera)
{
  this->Window.Draw(camera);
  const std::vector<std::uint8_t> pixels = this->Window.ReadPixels();
  std::set<std::size_t> owners;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
  {
    const std::uint32_t number = pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2];
    if (number >= 1 && number <= this->Opaque.size())
    {
      owners.insert(this->Opaque[number - 1]);
    }
  }
  return { owners.begin(), owners.end() };
}

}
