#include "vtkAssemblyActors.h"

#include "Core/assembly/Explosion.h"
#include "assembly/DrawnParts.h"
#include "assembly/FoundParts.h"
#include "assembly/PartLooks.h"
#include "assembly/PlacedGeometry.h"
#include "scene/PropertyCopy.h"
#include "vtkAssemblyReader.h"
#include "vtkBoundingBox.h"
#include "vtkInformationDoubleKey.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAssemblyActors);
vtkInformationKeyMacro(vtkAssemblyActors, ALPHA_CUTOFF, Double);

namespace
{
using vitrine::AddedPart;

vitrine::ExplodedPart Exploded(const AddedPart& part, const std::string& path)
{
  vitrine::ExplodedPart exploded{ path, glm::dvec3(1.0), glm::dvec3(-1.0) };
  const vtkBoundingBox box = vitrine::PlacedBox(part.Geometry, part.Place);
  if (box.IsValid())
  {
    box.GetMinPoint(exploded.Min.x, exploded.Min.y, exploded.Min.z);
    box.GetMaxPoint(exploded.Max.x, exploded.Max.y, exploded.Max.z);
  }
  return exploded;
}
}

//------------------------------------------------------------------------------
vtkAssemblyActors::vtkAssemblyActors()
  : Private(new vitrine::DrawnParts)
{
}

//------------------------------------------------------------------------------
vtkAssemblyActors::~vtkAssemblyActors() = default;

//------------------------------------------------------------------------------
void vtkAssemblyActors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n";
  os << indent << "NumberOfActors: " << this->Private->Actors().size() << "\n";
}

//------------------------------------------------------------------------------
bool vtkAssemblyActors::AddParts(vtkAssemblyReader* reader)
{
  if (!reader || !reader->Open())
  {
    vtkErrorMacro("AddParts() takes a reader of a file that can be read"
      << (reader ? ": " + reader->GetErrorMessage() : std::string()));
    return false;
  }
  for (int i = 0; i < reader->GetNumberOfParts(); ++i)
  {
    const int added = this->AddPart(reader->GetPartGeometry(i), reader->GetPartPlace(i),
      reader->GetPartProperty(i), reader->GetPartKeys(i), reader->GetPartIsTranslucent(i));
    if (added < 0)
    {
      return false;
    }
    this->SetPartNames(
      added, reader->GetPartName(i), reader->GetPartPath(i), reader->GetPartMaterialName(i));
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::AddPart(vtkPolyData* geometry, vtkMatrix4x4* place, vtkProperty* property,
  vtkInformation* keys, bool isTranslucent)
{
  if (!geometry || !property || this->Private->IsMade())
  {
    vtkErrorMacro(<< (this->Private->IsMade() ? "AddPart() was called after actors were made"
                                              : "AddPart() takes a geometry and a property"));
    return -1;
  }
  this->Modified();
  return this->Private->Add({ geometry, place, property, keys, isTranslucent, {} });
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetNumberOfParts() const
{
  return this->Private->Count();
}

//------------------------------------------------------------------------------
vitrine::DrawnParts& vtkAssemblyActors::Drawn()
{
  this->Private->Make();
  return *this->Private;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetNumberOfActors()
{
  return static_cast<int>(this->Drawn().Actors().size());
}

//------------------------------------------------------------------------------
vtkActor* vtkAssemblyActors::GetActor(int actor)
{
  if (actor < 0 || actor >= this->GetNumberOfActors())
  {
    vtkErrorMacro("there is no actor " << actor << ": there are " << this->GetNumberOfActors());
    return nullptr;
  }
  return this->Drawn().Actors()[static_cast<std::size_t>(actor)];
}

//------------------------------------------------------------------------------
// AddActor() searches through all the props there are, which takes most of a large scene's time.
void vtkAssemblyActors::AddTo(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("AddTo() takes a renderer");
    return;
  }
  for (vtkActor* const actor : this->Drawn().Actors())
  {
    if (!actor->IsConsumer(renderer))
    {
      renderer->GetViewProps()->AddItem(actor);
      actor->AddConsumer(renderer);
    }
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::RemoveFrom(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("RemoveFrom() takes a renderer");
    return;
  }
  for (vtkActor* const actor : this->Drawn().Actors())
  {
    renderer->RemoveActor(actor);
  }
}

//------------------------------------------------------------------------------
bool vtkAssemblyActors::IsPart(int part)
{
  if (part >= 0 && part < this->GetNumberOfParts())
  {
    return true;
  }
  vtkErrorMacro("there is no part " << part << ": there are " << this->GetNumberOfParts());
  return false;
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartNames(
  int part, const std::string& name, const std::string& path, const std::string& material)
{
  if (this->IsPart(part))
  {
    this->Private->SetNames(part, name, { path, material });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::GetPartName(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::GetPartPath(int part)
{
  return this->IsPart(part) ? this->Private->Names()[static_cast<std::size_t>(part)].Path
                            : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::GetPartMaterialName(int part)
{
  return this->IsPart(part) ? this->Private->Names()[static_cast<std::size_t>(part)].Material
                            : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::FindParts(const std::string& pattern, vtkIdList* parts)
{
  return vitrine::FindParts(this->Private->Names(), pattern, parts);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkAssemblyActors::GetPartGeometry(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Geometry.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkAssemblyActors::GetPartPlace(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Place.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkProperty* vtkAssemblyActors::GetPartProperty(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Property.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkAssemblyActors::CopyPlacedGeometry(int part)
{
  if (!this->IsPart(part))
  {
    return nullptr;
  }
  const AddedPart& added = this->Private->Part(part);
  const vtkSmartPointer<vtkPolyData> placed = vitrine::PlaceGeometry(added.Geometry, added.Place);
  placed->Register(nullptr);
  return placed;
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::GetPlacedBounds(
  vtkPolyData* geometry, vtkMatrix4x4* place, double bounds[6])
{
  vitrine::PlacedBox(geometry, place).GetBounds(bounds);
}

//------------------------------------------------------------------------------
vtkActor* vtkAssemblyActors::GetPartActor(int part)
{
  return this->IsPart(part) ? this->Drawn().Place(part).Actor.Get() : nullptr;
}

//------------------------------------------------------------------------------
unsigned int vtkAssemblyActors::GetPartBlock(int part)
{
  return this->IsPart(part) ? this->Drawn().Place(part).FlatIndex : 0;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetPart(vtkActor* actor, unsigned int block)
{
  return this->Drawn().PartAt(actor, block);
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetKeys(vtkActor* actor, vtkInformation* keys)
{
  vitrine::SetKeys(actor, keys);
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetShownColor(vtkProperty* property, double red, double green, double blue)
{
  property->SetColor(vitrine::ColorToHold(property, { red, green, blue }).data());
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::GetShownColor(vtkProperty* property, double color[3])
{
  const std::array<double, 3> shown = vitrine::ShownColor(property);
  std::copy(shown.begin(), shown.end(), color);
}

//------------------------------------------------------------------------------
vtkProperty* vtkAssemblyActors::CopyProperty(vtkProperty* property)
{
  vtkSmartPointer<vtkProperty> copy = vitrine::CopyProperty(property);
  copy->Register(nullptr);
  return copy;
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartOpacity(int part, double opacity)
{
  if (!this->IsPart(part))
  {
    return;
  }
  if (std::isnan(opacity))
  {
    vtkErrorMacro("the opacity of a part is from 0 to 1, not NaN");
    return;
  }
  this->Drawn().SetOpacity(part, std::clamp(opacity, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartColor(int part, double red, double green, double blue)
{
  if (this->IsPart(part))
  {
    this->Drawn().SetColor(
      part, { std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0), std::clamp(blue, 0.0, 1.0) });
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartVisibility(int part, bool isVisible)
{
  if (this->IsPart(part))
  {
    this->Drawn().SetVisibility(part, isVisible);
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::ResetPart(int part)
{
  if (this->IsPart(part))
  {
    this->Drawn().ResetLook(part);
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartOffset(int part, double x, double y, double z)
{
  if (!this->IsPart(part))
  {
    return;
  }
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro("the offset of a part is finite, not (" << x << ", " << y << ", " << z << ")");
    return;
  }
  this->Drawn().SetOffset(part, { x, y, z });
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::GetPartOffset(int part, double offset[3])
{
  const glm::dvec3 moved = this->IsPart(part) ? this->Drawn().Place(part).Offset : glm::dvec3(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    offset[axis] = moved[axis];
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::Explode(double factor)
{
  if (!(factor >= 0.0 && factor <= 1000.0))
  {
    vtkErrorMacro("the factor of an exploded view is from 0 to 1000, not " << factor);
    return;
  }
  std::vector<vitrine::ExplodedPart> parts;
  for (int part = 0; part < this->GetNumberOfParts(); ++part)
  {
    parts.push_back(Exploded(
      this->Private->Part(part), this->Private->Names()[static_cast<std::size_t>(part)].Path));
  }
  const std::vector<glm::dvec3> offsets = vitrine::ExplodedOffsets(parts, factor);
  for (int part = 0; part < this->GetNumberOfParts(); ++part)
  {
    this->Drawn().SetOffset(part, offsets[static_cast<std::size_t>(part)]);
  }
}
