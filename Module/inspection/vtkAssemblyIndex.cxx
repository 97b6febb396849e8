#include "vtkAssemblyIndex.h"

#include "Core/measure/AssemblyIndex.h"
#include "inspection/PartTriangles.h"
#include "scene/CutProps.h"
#include "scene/Matrices.h"
#include "scene/PartNumbers.h"
#include "section/PartData.h"
#include "vtkAssemblyActors.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkWeakPointer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace
{

glm::dvec3 VectorOf(const double vector[3])
{
  return { vector[0], vector[1], vector[2] };
}

void Write(const glm::dvec3& from, double to[3])
{
  std::copy_n(&from.x, 3, to);
}

bool AreFinite(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}

/** A new column of a table. */
template <class Array>
Array* AddColumn(vtkTable* table, const char* name, int components = 1)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfComponents(components);
  table->AddColumn(column);
  return column;
}

void Fill(vtkIdList* list, const std::vector<std::uint32_t>& parts)
{
  list->Reset();
  for (const std::uint32_t part : parts)
  {
    list->InsertNextId(part);
  }
}

/** The names of all blocks that have data, by their flat indices. */
std::map<unsigned int, std::string> BlockNames(vtkDataObject* data)
{
  std::map<unsigned int, std::string> names;
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return names;
  }
  const auto at = vtk::TakeSmartPointer(blocks->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    const char* const name = at->HasCurrentMetaData()
      ? at->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    const unsigned int block = at->GetCurrentFlatIndex();
    names[block] = name ? name : "block " + std::to_string(block);
  }
  return names;
}

int NumberOf(vitrine::ClashKinds kind)
{
  switch (kind)
  {
    case vitrine::ClashKinds::Interfering:
      return vtkAssemblyIndex::INTERFERING;
    case vitrine::ClashKinds::Touching:
      return vtkAssemblyIndex::TOUCHING;
    case vitrine::ClashKinds::Near:
      break;
  }
  return vtkAssemblyIndex::NEAR_BY;
}

int InsideOf(const vitrine::Clash& clash)
{
  switch (clash.Enclosure)
  {
    case vitrine::Enclosures::FirstInSecond:
      return static_cast<int>(clash.First);
    case vitrine::Enclosures::SecondInFirst:
      return static_cast<int>(clash.Second);
    case vitrine::Enclosures::None:
      break;
  }
  return -1;
}

/** The ray of CastRay() with a direction of length 1, or why there is none. */
std::string MakeRay(
  const double origin[3], const double direction[3], double length, vitrine::Ray& ray)
{
  if (!AreFinite(origin, 3) || !AreFinite(direction, 3) || std::isnan(length))
  {
    return "the origin or the direction of the ray has a number that is not finite, or the length "
           "is no number";
  }
  const glm::dvec3 along = VectorOf(direction);
  const double largest = std::max({ std::abs(along.x), std::abs(along.y), std::abs(along.z) });
  if (!(largest > 0.0))
  {
    return "the direction of the ray is 0";
  }
  if (length < 0.0)
  {
    return "the length of the ray is negative";
  }
  ray = { VectorOf(origin), glm::normalize(along / largest), length };
  return {};
}

}

struct vtkAssemblyIndex::Content
{
  /** A geometry that parts share, and the cells of its triangles. */
  struct SharedMesh
  {
    vtkSmartPointer<vtkPolyData> Geometry; ///< kept, so that no other has its address
    std::shared_ptr<const vitrine::PartMesh> Mesh;
    std::shared_ptr<const std::vector<vtkIdType>> Cells;
  };

  struct IndexedPart
  {
    std::string Name;
    std::shared_ptr<const std::vector<vtkIdType>> Cells;
    vtkWeakPointer<vtkActor> Actor;
    unsigned int Block;
  };

  vitrine::AssemblyIndex Index;
  std::vector<IndexedPart> Parts;
  std::map<vtkPolyData*, SharedMesh> Meshes;
  bool IsBuilt = false;

  const SharedMesh& MeshOf(vtkPolyData* geometry)
  {
    SharedMesh& shared = this->Meshes[geometry];
    if (!shared.Geometry)
    {
      vitrine::PartTriangles triangles = vitrine::ReadTriangles(geometry);
      shared.Geometry = geometry;
      shared.Mesh = std::make_shared<vitrine::PartMesh>(triangles.Points, triangles.Corners);
      shared.Cells = std::make_shared<std::vector<vtkIdType>>(std::move(triangles.Cells));
    }
    return shared;
  }

  int Add(vtkPolyData* geometry, vtkMatrix4x4* place, std::string name, vtkActor* actor,
    unsigned int block)
  {
    const SharedMesh& shared = this->MeshOf(geometry);
    this->Index.Add(shared.Mesh, place ? vitrine::MatrixOf(place) : glm::dmat4(1.0));
    this->Parts.push_back({ std::move(name), shared.Cells, actor, block });
    this->IsBuilt = false;
    return static_cast<int>(this->Parts.size()) - 1;
  }

  const vitrine::PlacedPart& Placed(int part) const
  {
    return this->Index.At(static_cast<std::uint32_t>(part));
  }

  const IndexedPart& Part(int part) const { return this->Parts[static_cast<std::size_t>(part)]; }

  const vitrine::AssemblyIndex& Built()
  {
    if (!this->IsBuilt)
    {
      this->Index.Build();
      this->IsBuilt = true;
    }
    return this->Index;
  }
};

vtkStandardNewMacro(vtkAssemblyIndex);

vtkAssemblyIndex::vtkAssemblyIndex()
  : Private(std::make_unique<Content>())
{
}

vtkAssemblyIndex::~vtkAssemblyIndex() = default;

void vtkAssemblyIndex::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
}

bool vtkAssemblyIndex::IsPart(int part)
{
  const bool is = part >= 0 && part < this->GetNumberOfParts();
  if (!is)
  {
    vtkErrorMacro(<< "There is no part " << part << " among " << this->GetNumberOfParts() << ".");
  }
  return is;
}

bool vtkAssemblyIndex::IsThere(const vtkObject* object)
{
  if (!object)
  {
    vtkErrorMacro(<< "The renderer, the table or the list is null.");
  }
  return object != nullptr;
}

int vtkAssemblyIndex::AddPart(vtkPolyData* geometry, vtkMatrix4x4* place, const std::string& name)
{
  if (!geometry)
  {
    vtkErrorMacro(<< "A part needs a geometry.");
    return -1;
  }
  return this->Private->Add(geometry, place, name, nullptr, 0);
}

void vtkAssemblyIndex::AddAssembly(vtkAssemblyActors* actors)
{
  for (int part = 0; actors && part < actors->GetNumberOfParts(); ++part)
  {
    this->Private->Add(actors->GetPartGeometry(part), actors->GetPartPlace(part),
      actors->GetPartName(part), actors->GetPartActor(part), actors->GetPartBlock(part));
  }
}

int vtkAssemblyIndex::AddActors(vtkRenderer* renderer)
{
  if (!this->IsThere(renderer))
  {
    return 0;
  }
  int leftOut = 0;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* const prop = props->GetNextProp(at))
  {
    const bool isCap = vitrine::IsCap(prop);
    prop->InitPathTraversal();
    while (vtkAssemblyPath* const path = isCap ? nullptr : prop->GetNextPath())
    {
      vtkAssemblyNode* const last = path->GetLastNode();
      if (auto* const actor = vtkActor::SafeDownCast(last->GetViewProp()))
      {
        const bool isShown = prop->GetVisibility() && actor->GetVisibility();
        leftOut += isShown ? this->AddProp(actor, last->GetMatrix()) : 1;
      }
    }
  }
  return leftOut;
}

int vtkAssemblyIndex::AddProp(vtkActor* actor, vtkMatrix4x4* place)
{
  std::vector<vitrine::DrawnData> drawn;
  vitrine::ForEachDrawn(actor, [&](const vitrine::DrawnData& data) { drawn.push_back(data); });
  const std::map<unsigned int, std::string> names = BlockNames(vitrine::BlocksOf(actor));
  for (const vitrine::DrawnData& data : drawn)
  {
    const auto name = names.find(data.Block);
    this->Private->Add(data.Data, place,
      name != names.end() ? name->second : "actor " + std::to_string(this->GetNumberOfParts()),
      actor, data.Block);
  }
  return static_cast<int>(std::max<std::size_t>(names.size(), 1) - drawn.size());
}

int vtkAssemblyIndex::GetNumberOfParts() const
{
  return static_cast<int>(this->Private->Parts.size());
}

std::string vtkAssemblyIndex::GetPartName(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Name : std::string();
}

int vtkAssemblyIndex::GetPartNumberOfTriangles(int part)
{
  return this->IsPart(part) ? static_cast<int>(this->Private->Placed(part).Mesh().TriangleCount())
                            : 0;
}

bool vtkAssemblyIndex::GetPartIsClosed(int part)
{
  return this->IsPart(part) && this->Private->Placed(part).IsClosed();
}

vtkActor* vtkAssemblyIndex::GetPartActor(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Actor.Get() : nullptr;
}

unsigned int vtkAssemblyIndex::GetPartBlock(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Block : 0;
}

bool vtkAssemblyIndex::CastRay(
  const double origin[3], const double direction[3], double length, vtkTable* crossings)
{
  if (!this->IsThere(crossings))
  {
    return false;
  }
  crossings->Initialize();
  auto* const parts = AddColumn<vtkIntArray>(crossings, "part");
  auto* const distances = AddColumn<vtkDoubleArray>(crossings, "distance");
  auto* const positions = AddColumn<vtkDoubleArray>(crossings, "position", 3);
  auto* const cells = AddColumn<vtkIdTypeArray>(crossings, "cell");
  auto* const entering = AddColumn<vtkIntArray>(crossings, "entering");
  vitrine::Ray ray;
  const std::string problem = MakeRay(origin, direction, length, ray);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "No ray is cast: " << problem << ".");
    return false;
  }
  for (const vitrine::PartCrossing& crossing : this->Private->Built().Crossings(ray))
  {
    const int part = static_cast<int>(crossing.Part);
    const glm::dvec3 position = ray.Origin + crossing.Distance * ray.Direction;
    const std::uint32_t triangle = this->Private->Placed(part).Mesh().SourceOf(crossing.Triangle);
    parts->InsertNextValue(part);
    distances->InsertNextValue(crossing.Distance);
    positions->InsertNextTuple(&position.x);
    cells->InsertNextValue((*this->Private->Part(part).Cells)[triangle]);
    entering->InsertNextValue(crossing.IsEntering ? 1 : 0);
  }
  return true;
}

bool vtkAssemblyIndex::FindWalls(
  const double origin[3], const double direction[3], double length, vtkTable* walls)
{
  if (!this->IsThere(walls))
  {
    return false;
  }
  walls->Initialize();
  auto* const parts = AddColumn<vtkIntArray>(walls, "part");
  auto* const starts = AddColumn<vtkDoubleArray>(walls, "start");
  auto* const ends = AddColumn<vtkDoubleArray>(walls, "end");
  vitrine::Ray ray;
  const std::string problem = MakeRay(origin, direction, length, ray);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "No ray is cast: " << problem << ".");
    return false;
  }
  for (const vitrine::Wall& wall : this->Private->Built().Walls(ray))
  {
    parts->InsertNextValue(static_cast<int>(wall.Part));
    starts->InsertNextValue(wall.Start);
    ends->InsertNextValue(wall.End);
  }
  return true;
}

int vtkAssemblyIndex::FindNearest(const double point[3], double nearest[3])
{
  if (!AreFinite(point, 3))
  {
    vtkErrorMacro(<< "Nothing is nearest to a point that has a number that is not finite.");
    return -1;
  }
  const auto near = this->Private->Built().Nearest(VectorOf(point));
  if (near)
  {
    Write(near->Point.Place, nearest);
  }
  return near ? static_cast<int>(near->Part) : -1;
}

bool vtkAssemblyIndex::FindPartsInBox(const double bounds[6], bool isWholly, vtkIdList* parts)
{
  if (!this->IsThere(parts))
  {
    return false;
  }
  parts->Reset();
  const vitrine::WideBox box{ { bounds[0], bounds[2], bounds[4] },
    { bounds[1], bounds[3], bounds[5] } };
  if (!AreFinite(bounds, 6) || box.IsEmpty())
  {
    vtkErrorMacro(<< "Nothing is in a box that is empty or has a number that is not finite.");
    return false;
  }
  const vitrine::AssemblyIndex& index = this->Private->Built();
  Fill(parts, isWholly ? index.PartsWithin(box) : index.PartsTouching(box));
  return true;
}

bool vtkAssemblyIndex::FindPartsInSphere(
  const double center[3], double radius, bool isWholly, vtkIdList* parts)
{
  if (!this->IsThere(parts))
  {
    return false;
  }
  parts->Reset();
  if (!AreFinite(center, 3) || !std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro(
      << "Nothing is in a sphere whose radius is negative, or that has a number that is "
         "not finite.");
    return false;
  }
  const glm::dvec3 middle = VectorOf(center);
  const vitrine::AssemblyIndex& index = this->Private->Built();
  Fill(parts, isWholly ? index.PartsWithin(middle, radius) : index.PartsTouching(middle, radius));
  return true;
}

double vtkAssemblyIndex::GetDistance(int first, int second, double onFirst[3], double onSecond[3])
{
  if (!this->IsPart(first) || !this->IsPart(second))
  {
    return -1.0;
  }
  const auto gap = this->Private->Index.Distance(
    static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second));
  if (!gap)
  {
    vtkErrorMacro(<< "A part without triangles has no distance.");
    return -1.0;
  }
  Write(gap->OnFirst, onFirst);
  Write(gap->OnSecond, onSecond);
  return gap->Distance;
}

double vtkAssemblyIndex::GetDefaultTolerance()
{
  const vitrine::WideBox& bounds = this->Private->Index.Bounds();
  return bounds.IsEmpty() ? 0.0 : glm::length(bounds.High - bounds.Low) / 1000.0;
}

bool vtkAssemblyIndex::FindClashes(double clearance, double tolerance, vtkTable* clashes)
{
  if (!this->IsThere(clashes))
  {
    return false;
  }
  clashes->Initialize();
  auto* const firsts = AddColumn<vtkIntArray>(clashes, "first");
  auto* const seconds = AddColumn<vtkIntArray>(clashes, "second");
  auto* const kinds = AddColumn<vtkIntArray>(clashes, "kind");
  auto* const depths = AddColumn<vtkDoubleArray>(clashes, "depth");
  auto* const distances = AddColumn<vtkDoubleArray>(clashes, "distance");
  auto* const positions = AddColumn<vtkDoubleArray>(clashes, "position", 3);
  auto* const inside = AddColumn<vtkIntArray>(clashes, "inside");
  const double limits[2] = { clearance, tolerance };
  if (!AreFinite(limits, 2) || clearance < 0.0 || tolerance < 0.0)
  {
    vtkErrorMacro(<< "Clearance and tolerance are finite numbers from 0 up, not " << clearance
                  << " and " << tolerance << ".");
    return false;
  }
  this->AbortExecute = 0;
  const auto goesOn = [this](double done)
  {
    this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    return this->AbortExecute == 0;
  };
  for (const vitrine::Clash& clash : this->Private->Index.Clashes({ clearance, tolerance }, goesOn))
  {
    firsts->InsertNextValue(static_cast<int>(clash.First));
    seconds->InsertNextValue(static_cast<int>(clash.Second));
    kinds->InsertNextValue(NumberOf(clash.Kind));
    depths->InsertNextValue(clash.Depth);
    distances->InsertNextValue(clash.Distance);
    positions->InsertNextTuple(&clash.Place.x);
    inside->InsertNextValue(InsideOf(clash));
  }
  return goesOn(1.0);
}

bool vtkAssemblyIndex::MaySee(int first, int second, vtkIdList* through)
{
  if (!this->IsPart(first) || !this->IsPart(second))
  {
    return false;
  }
  return this->Private->Built().MaySee(static_cast<std::uint32_t>(first),
    static_cast<std::uint32_t>(second),
    [through](std::uint32_t part)
    { return !through || through->IsId(static_cast<vtkIdType>(part)) < 0; });
}
