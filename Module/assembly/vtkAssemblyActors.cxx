#include "vtkAssemblyActors.h"

#include "Core/threads/ForEachInThreads.h"
#include "assembly/AssemblyLooks.h"
#include "assembly/ColorTextures.h"
#include "assembly/FoundParts.h"
#include "assembly/PlacedGeometry.h"
#include "vtkActor.h"
#include "vtkAssemblyReader.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkAssemblyActors);
vtkInformationKeyMacro(vtkAssemblyActors, ALPHA_CUTOFF, Double);

namespace vitrine
{
/** A part as it was added. */
struct AddedPart
{
  vtkSmartPointer<vtkPolyData> Geometry;
  vtkSmartPointer<vtkMatrix4x4> Place;
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkInformation> Keys;
  bool IsTranslucent;
  std::string Name;
};

/** Where a part is drawn: its actor, and its block there. */
struct DrawnPlace
{
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkPolyData> Block; ///< null if the actor has the part alone
  unsigned int FlatIndex = 0;
};

}

namespace
{
using vitrine::AddedPart;
using vitrine::DrawnPlace;

// Geometry of so many cells is worth an actor of its own for each part that shows it: its vertices are on the device
// once. Smaller geometry is copied, since an actor costs more than that.
constexpr vtkIdType LargeCells = 5000;

/** Colours at points are shown as they are. Other scalars are not colours. */
bool HasColors(vtkPolyData* geometry)
{
  vtkDataArray* const scalars = geometry->GetPointData()->GetScalars();
  return scalars && scalars->GetNumberOfComponents() >= 3;
}

/** Whether textures or colours at points hide the colour of the property. A block cannot be without them. */
bool HidesColor(const AddedPart& part)
{
  return HasColors(part.Geometry) || vitrine::HasColorTexture(part.Property);
}

/** What has to be alike in parts that are blocks of one actor: the look, and the arrays of their points. */
using GroupKey = std::tuple<vtkProperty*, vtkInformation*, bool, bool, bool, bool, int>;

GroupKey KeyOf(const AddedPart& part)
{
  vtkPointData* const data = part.Geometry->GetPointData();
  return { part.Property, part.Keys, part.IsTranslucent, data->GetNormals() != nullptr,
    data->GetTangents() != nullptr, data->GetTCoords() != nullptr,
    HasColors(part.Geometry) ? data->GetScalars()->GetNumberOfComponents() : 0 };
}

/** What a shader does with the alpha of the texture of the base colour, in place of what VTK does. */
std::string TextureAlphaCode(vtkInformation* keys)
{
  if (!keys || !keys->Has(vtkAssemblyActors::ALPHA_CUTOFF()))
  {
    return "opacity *= albedoSample.a;"; // glTF 2.0, 3.9.2
  }
  const double cutoff = keys->Get(vtkAssemblyActors::ALPHA_CUTOFF());
  std::ostringstream code;
  code.imbue(std::locale::classic()); // GLSL has decimal points.
  code << "if (albedoSample.a < " << std::fixed << cutoff << ") { discard; }";
  return cutoff > 0.0 ? code.str() : "";
}

bool HasLinearColors(vtkProperty* property)
{
  return property->GetInterpolation() == VTK_PBR && property->GetLighting();
}

/** The colour that a property has to hold so that it shows a colour of sRGB. */
std::array<double, 3> PropertyColor(vtkProperty* property, const double shown[3])
{
  std::array<double, 3> color = { shown[0], shown[1], shown[2] };
  if (HasLinearColors(property))
  {
    std::transform(color.begin(), color.end(), color.begin(),
      [](double value) { return std::pow(value, GAMMA); });
  }
  return color;
}

vtkSmartPointer<vtkActor> MakeActor(const AddedPart& part, vtkMapper* mapper)
{
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarVisibility(HasColors(part.Geometry));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(part.Property);
  // VTK 9.1 draws an opaque block of a translucent property in no pass otherwise.
  actor->SetForceTranslucent(part.IsTranslucent || part.Property->GetOpacity() < 1.0);
  vtkAssemblyActors::SetKeys(actor, part.Keys);
  return actor;
}

vtkCompositeDataDisplayAttributes* AttributesOf(const DrawnPlace& place)
{
  return static_cast<vtkCulledCompositePolyDataMapper*>(place.Actor->GetMapper())
    ->GetCompositeDataDisplayAttributes();
}
}

/** All parts, their actors once these are made, and where each part is. */
struct vtkAssemblyActors::Drawn
{
  std::vector<AddedPart> Added;
  std::vector<vitrine::PartNames> Names; ///< by part
  bool IsMade = false;
  std::vector<DrawnPlace> Places; ///< by part
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::map<vtkActor*, std::vector<int>> Parts; ///< by flat index

  void Make()
  {
    this->IsMade = true;
    this->Places.resize(this->Added.size());
    std::map<vtkPolyData*, int> uses;
    for (const AddedPart& part : this->Added)
    {
      ++uses[part.Geometry];
    }
    std::map<GroupKey, std::size_t> groupOf;
    std::vector<std::vector<int>> groups; // in the order of their first parts
    for (std::size_t i = 0; i < this->Added.size(); ++i)
    {
      const AddedPart& part = this->Added[i];
      const bool isSharedAndLarge =
        uses[part.Geometry] > 1 && part.Geometry->GetNumberOfCells() >= LargeCells;
      if (isSharedAndLarge || vitrine::IsFarForItsSize(part.Geometry, part.Place) ||
        HidesColor(part))
      {
        this->AddSingle(static_cast<int>(i));
        continue;
      }
      const auto [found, isNew] = groupOf.emplace(KeyOf(part), groups.size());
      if (isNew)
      {
        groups.emplace_back();
      }
      groups[found->second].push_back(static_cast<int>(i));
    }
    for (const std::vector<int>& parts : groups)
    {
      this->AddGroup(parts);
    }
  }

  const AddedPart& Part(int number) const { return this->Added[static_cast<std::size_t>(number)]; }

  // The actor gets a property of its own, so that the part can be given another look.
  void AddSingle(int number)
  {
    AddedPart part = this->Part(number);
    part.Property = vtk::TakeSmartPointer(CopyProperty(part.Property));
    vtkNew<vtkCulledPolyDataMapper> mapper;
    mapper->SetInputData(part.Geometry);
    const vtkSmartPointer<vtkActor> actor = MakeActor(part, mapper);
    if (part.Place)
    {
      actor->SetUserMatrix(part.Place);
    }
    this->Places[static_cast<std::size_t>(number)].Actor = actor;
    this->Add(actor, { number });
  }

  void AddGroup(const std::vector<int>& numbers)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> placed(numbers.size());
    vitrine::ForEachInThreads(numbers.size(),
      [&](std::size_t i)
      {
        const AddedPart& part = this->Part(numbers[i]);
        placed[i] = vitrine::PlaceGeometry(part.Geometry, part.Place);
      });
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetNumberOfBlocks(static_cast<unsigned int>(numbers.size()));
    vtkNew<vtkCulledCompositePolyDataMapper> mapper;
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    const vtkSmartPointer<vtkActor> actor = MakeActor(this->Part(numbers.front()), mapper);
    std::vector<int> parts{ -1 }; // The flat index of the whole data set is 0.
    for (unsigned int i = 0; i < numbers.size(); ++i)
    {
      blocks->SetBlock(i, placed[i]);
      this->Places[static_cast<std::size_t>(numbers[i])] = { actor, placed[i], i + 1 };
      parts.push_back(numbers[i]);
    }
    mapper->SetInputDataObject(blocks);
    this->Add(actor, std::move(parts));
  }

  void Add(const vtkSmartPointer<vtkActor>& actor, std::vector<int> parts)
  {
    this->Parts[actor] = std::move(parts);
    this->Actors.push_back(actor);
  }
};

//------------------------------------------------------------------------------
vtkAssemblyActors::vtkAssemblyActors()
  : Private(new Drawn)
{
}

//------------------------------------------------------------------------------
vtkAssemblyActors::~vtkAssemblyActors() = default;

//------------------------------------------------------------------------------
void vtkAssemblyActors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n";
  os << indent << "NumberOfActors: " << this->Private->Actors.size() << "\n";
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
  if (!geometry || !property || this->Private->IsMade)
  {
    vtkErrorMacro(<< (this->Private->IsMade ? "AddPart() was called after actors were made"
                                            : "AddPart() takes a geometry and a property"));
    return -1;
  }
  this->Private->Added.push_back({ geometry, place, property, keys, isTranslucent, {} });
  this->Private->Names.emplace_back();
  this->Modified();
  return this->GetNumberOfParts() - 1;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetNumberOfParts() const
{
  return static_cast<int>(this->Private->Added.size());
}

//------------------------------------------------------------------------------
vtkAssemblyActors::Drawn& vtkAssemblyActors::Actors()
{
  if (!this->Private->IsMade)
  {
    this->Private->Make();
  }
  return *this->Private;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetNumberOfActors()
{
  return static_cast<int>(this->Actors().Actors.size());
}

//------------------------------------------------------------------------------
vtkActor* vtkAssemblyActors::GetActor(int actor)
{
  if (actor < 0 || actor >= this->GetNumberOfActors())
  {
    vtkErrorMacro("there is no actor " << actor << ": there are " << this->GetNumberOfActors());
    return nullptr;
  }
  return this->Actors().Actors[static_cast<std::size_t>(actor)];
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
  for (vtkActor* const actor : this->Actors().Actors)
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
  for (vtkActor* const actor : this->Actors().Actors)
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
    const auto index = static_cast<std::size_t>(part);
    this->Private->Added[index].Name = name;
    this->Private->Names[index] = { path, material };
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
  return this->IsPart(part) ? this->Private->Names[static_cast<std::size_t>(part)].Path
                            : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::GetPartMaterialName(int part)
{
  return this->IsPart(part) ? this->Private->Names[static_cast<std::size_t>(part)].Material
                            : std::string();
}

//------------------------------------------------------------------------------
std::string vtkAssemblyActors::FindParts(const std::string& pattern, vtkIdList* parts)
{
  return vitrine::FindParts(this->Private->Names, pattern, parts);
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
vtkActor* vtkAssemblyActors::GetPartActor(int part)
{
  return this->IsPart(part) ? this->Actors().Places[static_cast<std::size_t>(part)].Actor.Get()
                            : nullptr;
}

//------------------------------------------------------------------------------
unsigned int vtkAssemblyActors::GetPartBlock(int part)
{
  return this->IsPart(part) ? this->Actors().Places[static_cast<std::size_t>(part)].FlatIndex : 0;
}

//------------------------------------------------------------------------------
int vtkAssemblyActors::GetPart(vtkActor* actor, unsigned int block)
{
  const Drawn& drawn = this->Actors();
  const auto found = drawn.Parts.find(actor);
  if (found == drawn.Parts.end())
  {
    return -1;
  }
  const std::vector<int>& parts = found->second;
  const bool isAlone = parts.size() == 1 || (parts.size() == 2 && block == 0);
  return isAlone ? parts.back() : block < parts.size() ? parts[block] : -1;
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetKeys(vtkActor* actor, vtkInformation* keys)
{
  if (keys)
  {
    vtkNew<vtkInformation> copy;
    copy->Copy(keys);
    actor->SetPropertyKeys(copy);
  }
  if (actor->GetProperty()->GetTexture(vitrine::LIT_COLOR_TEXTURE))
  {
    // The first is VTK's up to 9.5, and the second VTK's from then on.
    for (const char* const code :
      { "opacity = albedoSample.a;", "opacity = opacityUniform * albedoSample.a;" })
    {
      actor->GetShaderProperty()->AddFragmentShaderReplacement(
        code, /* replaceFirst= */ false, TextureAlphaCode(keys), /* replaceAll= */ true);
    }
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetShownColor(vtkProperty* property, double red, double green, double blue)
{
  const double shown[3] = { red, green, blue };
  property->SetColor(PropertyColor(property, shown).data());
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::GetShownColor(vtkProperty* property, double color[3])
{
  property->GetColor(color);
  if (HasLinearColors(property))
  {
    std::transform(
      color, color + 3, color, [](double value) { return std::pow(value, 1.0 / GAMMA); });
  }
}

//------------------------------------------------------------------------------
vtkProperty* vtkAssemblyActors::CopyProperty(vtkProperty* property)
{
  vtkProperty* const copy = vtkProperty::New();
  copy->DeepCopy(property);
  copy->SetEmissiveFactor(property->GetEmissiveFactor());
  // DeepCopy() has taken the textures without a reference, which RemoveAllTextures() gives up.
  for (const auto& [name, texture] : copy->GetAllTextures())
  {
    texture->Register(copy);
  }
  copy->RemoveAllTextures();
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    copy->SetTexture(name.c_str(), texture);
  }
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
  const DrawnPlace& place = this->Actors().Places[static_cast<std::size_t>(part)];
  const double clamped = std::clamp(opacity, 0.0, 1.0);
  if (place.Block)
  {
    AttributesOf(place)->SetBlockOpacity(place.Block, clamped);
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    place.Actor->GetProperty()->SetOpacity(clamped);
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartColor(int part, double red, double green, double blue)
{
  if (!this->IsPart(part))
  {
    return;
  }
  const DrawnPlace& place = this->Actors().Places[static_cast<std::size_t>(part)];
  const double shown[3] = { std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0),
    std::clamp(blue, 0.0, 1.0) };
  if (place.Block)
  {
    const std::array<double, 3> color = PropertyColor(place.Actor->GetProperty(), shown);
    AttributesOf(place)->SetBlockColor(place.Block, color.data());
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    SetShownColor(place.Actor->GetProperty(), shown[0], shown[1], shown[2]);
    vitrine::RemoveColorTextures(place.Actor->GetProperty());
    place.Actor->GetMapper()->ScalarVisibilityOff();
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::SetPartVisibility(int part, bool isVisible)
{
  if (!this->IsPart(part))
  {
    return;
  }
  const DrawnPlace& place = this->Actors().Places[static_cast<std::size_t>(part)];
  if (place.Block)
  {
    AttributesOf(place)->SetBlockVisibility(place.Block, isVisible);
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    place.Actor->SetVisibility(isVisible);
  }
}

//------------------------------------------------------------------------------
void vtkAssemblyActors::ResetPart(int part)
{
  if (!this->IsPart(part))
  {
    return;
  }
  const DrawnPlace& place = this->Actors().Places[static_cast<std::size_t>(part)];
  if (place.Block)
  {
    vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(place);
    attributes->RemoveBlockOpacity(place.Block);
    attributes->RemoveBlockColor(place.Block);
    attributes->RemoveBlockVisibility(place.Block);
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    place.Actor->SetProperty(vtk::TakeSmartPointer(
      CopyProperty(this->Private->Added[static_cast<std::size_t>(part)].Property)));
    place.Actor->GetMapper()->SetScalarVisibility(
      HasColors(this->Private->Added[static_cast<std::size_t>(part)].Geometry));
    place.Actor->VisibilityOn();
  }
}
