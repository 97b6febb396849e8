#include "scene/Scene.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTransform.h"

#include <algorithm>
#include <map>
#include <set>

namespace program
{

namespace
{
std::int64_t CountFanTriangles(vtkCellArray* cells)
{
  std::int64_t triangles = 0;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    triangles += std::max<vtkIdType>(0, cells->GetCellSize(i) - 2);
  }
  return triangles;
}

/** Copies of the objects that hold resources of a window; one copy for each original. */
class WindowCopies
{
public:
  vtkSmartPointer<vtkTexture> Copy(vtkTexture* original)
  {
    vtkSmartPointer<vtkTexture>& copy = this->Textures[original];
    if (!copy)
    {
      copy = vtkSmartPointer<vtkTexture>::New();
      copy->SetInputDataObject(original->GetInputDataObject(0, 0));
      copy->SetTransform(original->GetTransform());
      copy->SetColorMode(original->GetColorMode());
      copy->SetBlendingMode(original->GetBlendingMode());
      copy->SetMipmap(original->GetMipmap());
      copy->SetRepeat(original->GetRepeat());
      copy->SetEdgeClamp(original->GetEdgeClamp());
      copy->SetInterpolate(original->GetInterpolate());
      copy->SetUseSRGBColorSpace(original->GetUseSRGBColorSpace());
    }
    return copy;
  }

  vtkSmartPointer<vtkProperty> Copy(vtkProperty* original)
  {
    vtkSmartPointer<vtkProperty>& copy = this->Properties[original];
    if (!copy)
    {
      copy = vtkSmartPointer<vtkProperty>::New();
      copy->DeepCopy(original);
      copy->SetEmissiveFactor(original->GetEmissiveFactor()); // DeepCopy() of VTK 9.1 forgets it
      for (const auto& [name, texture] : copy->GetAllTextures())
      {
        texture->Register(copy); // DeepCopy() of VTK 9.1 forgets this too
      }
      copy->RemoveAllTextures();
      for (const auto& [name, texture] : original->GetAllTextures())
      {
        copy->SetTexture(name.c_str(), this->Copy(texture));
      }
    }
    return copy;
  }

private:
  std::map<vtkTexture*, vtkSmartPointer<vtkTexture>> Textures;
  std::map<vtkProperty*, vtkSmartPointer<vtkProperty>> Properties;
};

/** Colours at points or cells are shown as they are; other scalars are not colours. */
bool HasColors(vtkPolyData* geometry)
{
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(geometry->GetPointData()),
         static_cast<vtkDataSetAttributes*>(geometry->GetCellData()) })
  {
    vtkDataArray* scalars = data->GetScalars();
    if (scalars && scalars->GetNumberOfComponents() >= 3)
    {
      return true;
    }
  }
  return false;
}

/**
 * With a texture of the base colour, VTK's shader takes the opacity from the texture alone. It is the product of
 * both (glTF 2.0, 3.9.2).
 */
void MultiplyTextureIntoOpacity(vtkActor* actor)
{
  if (actor->GetProperty()->GetTexture("albedoTex"))
  {
    actor->GetShaderProperty()->AddFragmentShaderReplacement("opacity = albedoSample.a;",
      /* replaceFirst= */ false, "opacity *= albedoSample.a;", /* replaceAll= */ true);
  }
}

vtkSmartPointer<vtkPolyDataMapper> MakeMapper(const Part& part)
{
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (part.SphereRadius > 0.0)
  {
    vtkNew<vtkOpenGLSphereMapper> spheres;
    spheres->SetRadius(static_cast<float>(part.SphereRadius));
    mapper = spheres;
  }
  else
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  }
  mapper->SetInputData(part.Geometry);
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarVisibility(HasColors(part.Geometry));
  mapper->SetClippingPlanes(part.ClippingPlanes);
  return mapper;
}

vtkSmartPointer<vtkActor> MakeActor(const Part& part, WindowCopies& copies)
{
  const vtkSmartPointer<vtkPolyDataMapper> mapper = MakeMapper(part);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(copies.Copy(part.Material));
  MultiplyTextureIntoOpacity(actor);
  actor->SetForceTranslucent(part.ForceTranslucent);
  if (part.Transform)
  {
    actor->SetUserMatrix(part.Transform);
  }
  if (part.Texture)
  {
    actor->SetTexture(copies.Copy(part.Texture));
  }
  if (part.Keys)
  {
    vtkNew<vtkInformation> keys; // passes write into it
    keys->Copy(part.Keys);
    actor->SetPropertyKeys(keys);
  }
  return actor;
}

/** AddActor() without its search through all the actors there are, which takes most of a large scene's time. */
void AppendActor(vtkRenderer* renderer, vtkActor* actor)
{
  renderer->GetViewProps()->AddItem(actor);
  actor->AddConsumer(renderer);
}
}

std::array<double, 6> PartBounds(const Part& part)
{
  std::array<double, 6> local;
  part.Geometry->GetBounds(local.data());
  if (!part.Transform)
  {
    return local;
  }
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[4] = { local[corner & 1], local[2 + ((corner >> 1) & 1)],
      local[4 + ((corner >> 2) & 1)], 1.0 };
    double world[4];
    part.Transform->MultiplyPoint(point, world);
    box.AddPoint(world);
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

std::array<double, 6> SceneBounds(const Scene& scene)
{
  vtkBoundingBox box;
  for (const Part& part : scene.Parts)
  {
    box.AddBounds(PartBounds(part).data());
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

std::int64_t CountTriangles(vtkPolyData* geometry)
{
  return CountFanTriangles(geometry->GetPolys()) + CountFanTriangles(geometry->GetStrips());
}

std::size_t CountMaterials(const Scene& scene)
{
  std::set<vtkProperty*> materials;
  for (const Part& part : scene.Parts)
  {
    materials.insert(part.Material);
  }
  return materials.size();
}

void MakeOpaque(Scene& scene, double leastOpacity)
{
  for (Part& part : scene.Parts)
  {
    if (part.Material->GetOpacity() >= leastOpacity)
    {
      part.Material->SetOpacity(1.0);
      part.ForceTranslucent = false;
    }
  }
}

void MultiplyOpacity(Scene& scene, double factor)
{
  std::set<vtkProperty*> done;
  for (const Part& part : scene.Parts)
  {
    if (done.insert(part.Material).second)
    {
      part.Material->SetOpacity(part.Material->GetOpacity() * factor);
    }
  }
}

bool IsTranslucent(const Part& part)
{
  WindowCopies copies;
  return MakeActor(part, copies)->HasTranslucentPolygonalGeometry() != 0;
}

std::vector<vtkSmartPointer<vtkActor>> AddActors(const Scene& scene, vtkRenderer* renderer)
{
  WindowCopies copies;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (const Part& part : scene.Parts)
  {
    actors.push_back(MakeActor(part, copies));
    AppendActor(renderer, actors.back());
  }
  return actors;
}

}
