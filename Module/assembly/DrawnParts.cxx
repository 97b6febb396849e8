#include "assembly/DrawnParts.h"

#include "Core/threads/ForEachInThreads.h"
#include "assembly/ColorTextures.h"
#include "assembly/PartLooks.h"
#include "assembly/PlacedGeometry.h"
#include "scene/PropertyCopy.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <tuple>
#include <utility>

namespace vitrine
{

namespace
{

// Geometry of so many cells is worth an actor of its own for each part that shows it: its vertices are on the device
// once. Smaller geometry is copied, since an actor costs more than that.
constexpr vtkIdType LargeCells = 5000;

/** Whether textures or colours at points hide the colour of the property. A block cannot be without them. */
bool HidesColor(const AddedPart& part)
{
  return HasColors(part.Geometry) || HasColorTexture(part.Property);
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

vtkSmartPointer<vtkActor> MakeActor(const AddedPart& part, vtkMapper* mapper)
{
  mapper->StaticOn(); // No pipeline makes the data, so none has to be asked whether it changed.
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarVisibility(HasColors(part.Geometry));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(part.Property);
  // VTK 9.1 draws an opaque block of a translucent property in no pass otherwise.
  actor->SetForceTranslucent(part.IsTranslucent || part.Property->GetOpacity() < 1.0);
  SetKeys(actor, part.Keys);
  return actor;
}

vtkCompositeDataDisplayAttributes* AttributesOf(const DrawnPlace& place)
{
  return static_cast<vtkCulledCompositePolyDataMapper*>(place.Actor->GetMapper())
    ->GetCompositeDataDisplayAttributes();
}

/** Returns the place of a part that is moved by an offset in WC. */
vtkSmartPointer<vtkMatrix4x4> MovedPlace(vtkMatrix4x4* place, const glm::dvec3& offset)
{
  auto moved = vtkSmartPointer<vtkMatrix4x4>::New();
  if (place)
  {
    moved->DeepCopy(place);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    moved->SetElement(axis, 3, moved->GetElement(axis, 3) + offset[axis]);
  }
  return moved;
}

vtkSmartPointer<vtkPoints> MovedPoints(vtkPoints* points, const glm::dvec3& offset)
{
  auto moved = vtkSmartPointer<vtkPoints>::New();
  moved->SetDataType(points->GetDataType());
  moved->SetNumberOfPoints(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    moved->SetPoint(i, point[0] + offset.x, point[1] + offset.y, point[2] + offset.z);
  }
  return moved;
}
}

int DrawnParts::Add(AddedPart part)
{
  this->Added.push_back(std::move(part));
  this->NamesOfParts.emplace_back();
  return this->Count() - 1;
}

void DrawnParts::SetNames(int number, const std::string& name, const PartNames& names)
{
  this->Added[static_cast<std::size_t>(number)].Name = name;
  this->NamesOfParts[static_cast<std::size_t>(number)] = names;
}

void DrawnParts::Make()
{
  if (this->HasActors)
  {
    return;
  }
  this->HasActors = true;
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
    if (isSharedAndLarge || IsFarForItsSize(part.Geometry, part.Place) || HidesColor(part))
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

// The actor gets a property of its own, so that the part can be given another look.
void DrawnParts::AddSingle(int number)
{
  AddedPart part = this->Part(number);
  part.Property = CopyProperty(part.Property);
  vtkNew<vtkCulledPolyDataMapper> mapper;
  mapper->SetInputData(part.Geometry);
  const vtkSmartPointer<vtkActor> actor = MakeActor(part, mapper);
  if (part.Place)
  {
    actor->SetUserMatrix(part.Place);
  }
  this->PlaceOf(number).Actor = actor;
  this->AddActor(actor, { number });
}

void DrawnParts::AddGroup(const std::vector<int>& numbers)
{
  std::vector<vtkSmartPointer<vtkPolyData>> placed(numbers.size());
  ForEachInThreads(numbers.size(),
    [&](std::size_t i)
    {
      const AddedPart& part = this->Part(numbers[i]);
      placed[i] = PlaceGeometry(part.Geometry, part.Place);
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
    this->PlaceOf(numbers[i]) = { actor, placed[i], i + 1, nullptr, {} };
    parts.push_back(numbers[i]);
  }
  mapper->SetInputDataObject(blocks);
  this->AddActor(actor, std::move(parts));
}

void DrawnParts::AddActor(const vtkSmartPointer<vtkActor>& actor, std::vector<int> parts)
{
  this->Parts[actor] = std::move(parts);
  this->ActorsOfParts.push_back(actor);
}

int DrawnParts::PartAt(vtkActor* actor, unsigned int block) const
{
  const auto found = this->Parts.find(actor);
  if (found == this->Parts.end())
  {
    return -1;
  }
  const std::vector<int>& parts = found->second;
  const bool isAlone = parts.size() == 1 || (parts.size() == 2 && block == 0);
  return isAlone ? parts.back() : block < parts.size() ? parts[block] : -1;
}

void DrawnParts::SetOpacity(int number, double opacity)
{
  const DrawnPlace& place = this->Place(number);
  if (place.Block)
  {
    AttributesOf(place)->SetBlockOpacity(place.Block, opacity);
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    place.Actor->GetProperty()->SetOpacity(opacity);
  }
}

void DrawnParts::SetColor(int number, const std::array<double, 3>& shown)
{
  const DrawnPlace& place = this->Place(number);
  vtkProperty* const property = place.Actor->GetProperty();
  const std::array<double, 3> color = ColorToHold(property, shown);
  if (place.Block)
  {
    AttributesOf(place)->SetBlockColor(place.Block, color.data());
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    property->SetColor(color[0], color[1], color[2]);
    RemoveColorTextures(property);
    place.Actor->GetMapper()->ScalarVisibilityOff();
  }
}

void DrawnParts::SetVisibility(int number, bool isVisible)
{
  const DrawnPlace& place = this->Place(number);
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

void DrawnParts::SetOffset(int number, const glm::dvec3& offset)
{
  DrawnPlace& place = this->PlaceOf(number);
  if (place.Offset == offset)
  {
    return;
  }
  place.Offset = offset;
  if (!place.Block)
  {
    place.Actor->SetUserMatrix(MovedPlace(this->Part(number).Place, offset));
    return;
  }
  if (!place.Unmoved)
  {
    place.Unmoved = place.Block->GetPoints();
  }
  // New points also for no offset: a block keeps its bounds where its points are older than these.
  place.Block->SetPoints(MovedPoints(place.Unmoved, offset));
  place.Actor->GetMapper()->GetInputDataObject(0, 0)->Modified();
}

void DrawnParts::ResetLook(int number)
{
  const DrawnPlace& place = this->Place(number);
  const AddedPart& part = this->Part(number);
  if (place.Block)
  {
    vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(place);
    attributes->RemoveBlockOpacity(place.Block);
    attributes->RemoveBlockColor(place.Block);
    attributes->RemoveBlockVisibility(place.Block);
    attributes->Modified(); // VTK does not notice by itself that one was removed
    place.Actor->GetMapper()->Modified();
  }
  else
  {
    place.Actor->SetProperty(CopyProperty(part.Property));
    place.Actor->GetMapper()->SetScalarVisibility(HasColors(part.Geometry));
    place.Actor->VisibilityOn();
  }
}

}
