#include "culling/ItemBuffer.h"

#include "culling/MergedMesh.h"
#include "methods/VTKMethods.h"

#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <set>

namespace program
{

namespace
{

/** Numbers count from 1; the background is none of them. */
Scene NumberParts(const Scene& scene, std::size_t& count)
{
  MergedMesh mesh;
  for (const Part& part : scene.Parts)
  {
    if (!IsTranslucent(part) && part.Geometry->GetNumberOfPolys() > 0)
    {
      ++count;
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
  numbered.Parts.push_back(all);
  return numbered;
}
}

ItemBuffer::ItemBuffer(const Scene& scene, PictureSize size)
  : Numbered(NumberParts(scene, this->Parts))
  , Window(this->Numbered, MakeVTKOIT(), size, 0)
{
}

std::size_t ItemBuffer::CountOwners(vtkCamera* camera)
{
  this->Window.Draw(camera);
  const std::vector<std::uint8_t> pixels = this->Window.ReadPixels();
  std::set<std::uint32_t> owners;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
  {
    const std::uint32_t number = pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2];
    if (number >= 1 && number <= this->Parts)
    {
      owners.insert(number);
    }
  }
  return owners.size();
}

}
