#include "scene/Scene.h"

#include "vtkActor.h"
#include "vtkAssemblyActors.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPartOutlines.h"
#include "vtkPartXRay.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSection.h"
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
      copy = CopyMaterial(original);
      for (const auto& [name, texture] : original->GetAllTextures())
      {
        copy->RemoveTexture(
          name.c_str()); // VTK warns of a texture that another takes the place of.
        copy->SetTexture(name.c_str(), this->Copy(texture));
      }
    }
    return copy;
  }

private:
  std::map<vtkTexture*, vtkSmartPointer<vtkTexture>> Textures;
  std::map<vtkProperty*, vtkSmartPointer<vtkProperty>> Properties;
};

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
  mapper->SetScalarVisibility(
    HasColors(part.Geometry->GetPointData()) || HasColors(part.Geometry->GetCellData()));
  mapper->SetClippingPlanes(part.ClippingPlanes);
  return mapper;
}

vtkSmartPointer<vtkActor> MakeActor(const Part& part, WindowCopies& copies)
{
  const vtkSmartPointer<vtkPolyDataMapper> mapper = MakeMapper(part);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(copies.Copy(part.Material));
  vtkAssemblyActors::SetKeys(actor, part.Keys);
  actor->SetForceTranslucent(part.ForceTranslucent);
  if (part.Transform)
  {
    actor->SetUserMatrix(part.Transform);
  }
  if (part.Texture)
  {
    actor->SetTexture(copies.Copy(part.Texture));
  }
  return actor;
}

std::vector<vtkSmartPointer<vtkActor>> MakeBlocks(
  const Scene& scene, WindowCopies& copies, vtkAssemblyActors* blocks)
{
  for (const Part& part : scene.Parts)
  {
    if (part.MayBeBlock)
    {
      blocks->AddPart(part.Geometry, part.Transform, copies.Copy(part.Material), part.Keys,
        part.ForceTranslucent);
    }
  }
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < blocks->GetNumberOfActors(); ++i)
  {
    actors.emplace_back(blocks->GetActor(i));
  }
  return actors;
}

/** AddActor() without its search through all the actors there are, which takes most of a large scene's time. */
void AppendActor(vtkRenderer* renderer, vtkActor* actor)
{
  renderer->GetViewProps()->AddItem(actor);
  actor->AddConsumer(renderer);
}
}

std::string PathOf(const Part& part)
{
  return part.Path.empty() ? "/" + part.Name : part.Path;
}

bool HasColors(vtkDataSetAttributes* data)
{
  return data->GetScalars() && data->GetScalars()->GetNumberOfComponents() >= 3;
}

std::vector<std::string> PartPaths(const Scene& scene)
{
  std::map<std::string, int> counts;
  std::vector<std::string> paths;
  for (const Part& part : scene.Parts)
  {
    const std::string path = PathOf(part);
    const int count = ++counts[path];
    paths.push_back(count == 1 ? path : path + " (" + std::to_string(count) + ")");
  }
  return paths;
}

std::string PathStep(const std::string& name)
{
  std::string step = "/" + name;
  std::replace(step.begin() + 1, step.end(), '/', '_');
  return step;
}

std::array<double, 6> PartBounds(const Part& part)
{
  std::array<double, 6> bounds;
  vtkAssemblyActors::GetPlacedBounds(part.Geometry, part.Transform, bounds.data());
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

void DrawManyPartsAsBlocks(Scene& scene)
{
  const std::size_t many = 500;
  for (Part& part : scene.Parts)
  {
    part.MayBeBlock = scene.Parts.size() >= many && !part.Texture && part.SphereRadius == 0.0 &&
      !HasColors(part.Geometry->GetCellData());
  }
}

void DrawPartsApart(Scene& scene)
{
  for (Part& part : scene.Parts)
  {
    part.MayBeBlock = false;
  }
}

vtkSmartPointer<vtkProperty> CopyMaterial(vtkProperty* material)
{
  return vtk::TakeSmartPointer(vtkAssemblyActors::CopyProperty(material));
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

namespace
{
/** Have planes leave parts whole, and give caps their hatches and edges. */
void ApplyCutLooks(
  const Scene& scene, const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkSection* section)
{
  std::size_t actor = 0;
  for (const Part& part : scene.Parts)
  {
    if (part.Hatch)
    {
      section->SetHatchOf(actors[actor], *part.Hatch);
    }
    for (int i = 0; part.IsKeptWhole && i < section->GetNumberOfPlanes(); ++i)
    {
      section->SetParts(section->GetPlane(i), vtkSection::ALL_BUT_CHOSEN);
      section->ChoosePart(section->GetPlane(i), actors[actor]);
    }
    actor += part.MayBeBlock ? 0 : 1;
  }
  section->SetHatch(scene.Hatch);
  section->SetEdgeWidth(scene.CutEdges.value_or(section->GetEdgeWidth()));
}
}

std::vector<vtkSmartPointer<vtkActor>> AddActors(const Scene& scene, vtkRenderer* renderer)
{
  vtkNew<vtkAssemblyActors> blocks;
  return AddActors(scene, renderer, blocks);
}

std::vector<vtkSmartPointer<vtkActor>> AddActors(
  const Scene& scene, vtkRenderer* renderer, vtkAssemblyActors* blocks)
{
  WindowCopies copies;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (const Part& part : scene.Parts)
  {
    if (!part.MayBeBlock)
    {
      actors.push_back(MakeActor(part, copies));
    }
  }
  for (vtkSmartPointer<vtkActor>& actor : MakeBlocks(scene, copies, blocks))
  {
    actors.push_back(std::move(actor));
  }
  for (vtkActor* const actor : actors)
  {
    AppendActor(renderer, actor);
  }
  return actors;
}

void CutSections(
  const Scene& scene, const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkRenderer* renderer)
{
  if (vtkSection* const former = vtkSection::GetAttached(renderer))
  {
    former->Detach();
  }
  if (scene.Sections.empty() && !scene.SectionBox)
  {
    return;
  }
  vtkNew<vtkSection> section;
  for (const auto& [x, y, z, distance] : scene.Sections)
  {
    const double share = distance / (x * x + y * y + z * z);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(x, y, z);
    plane->SetOrigin(share * x, share * y, share * z);
    section->AddPlane(plane);
  }
  if (scene.SectionBox)
  {
    const auto [xmin, xmax, ymin, ymax, zmin, zmax] = *scene.SectionBox;
    section->SetBox(xmin, xmax, ymin, ymax, zmin, zmax, /* keepInside= */ true);
  }
  ApplyCutLooks(scene, actors, section);
  section->Attach(renderer);
}

void ShowLooks(
  const Scene& scene, const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkRenderer* renderer)
{
  vtkNew<vtkPartOutlines> outlines;
  vtkNew<vtkPartXRay> xray;
  std::size_t actor = 0;
  for (const Part& part : scene.Parts)
  {
    if (part.IsOutlined)
    {
      outlines->AddPart(actors[actor]);
    }
    if (part.IsXRayed)
    {
      xray->AddPart(actors[actor]);
    }
    actor += part.MayBeBlock ? 0 : 1;
  }
  xray->SetFalloff(scene.XRayFalloff);
  if (outlines->GetNumberOfParts() > 0)
  {
    outlines->Attach(renderer);
  }
  if (xray->GetNumberOfParts() > 0)
  {
    xray->Attach(renderer);
  }
}

}
