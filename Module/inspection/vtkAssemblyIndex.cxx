#include "vtkAssemblyIndex.h"

#include "inspection/AnswerTables.h"
#include "inspection/IndexedParts.h"
#include "scene/CutProps.h"
#include "scene/PartNumbers.h"
#include "scene/Settings.h"
#include "section/PartData.h"
#include "vtkAssemblyActors.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
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

void Fill(vtkIdList* list, const std::vector<std::uint32_t>& parts)
{
  list->Reset();
  for (const std::uint32_t part : parts)
  {
    list->InsertNextId(part);
  }
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

struct vtkAssemblyIndex::Content : vitrine::IndexedParts
{
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
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
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

bool vtkAssemblyIndex::TakeRay(
  const double origin[3], const double direction[3], double length, vitrine::Ray& ray)
{
  const std::string problem = MakeRay(origin, direction, length, ray);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "No ray is cast: " << problem << ".");
  }
  return problem.empty();
}

template <class Ask>
bool vtkAssemblyIndex::Answers(const Ask& ask)
{
  this->Problem.clear();
  try
  {
    ask();
  }
  catch (const std::runtime_error& error)
  {
    this->Problem = error.what();
    vtkErrorMacro(<< this->Problem << ".");
  }
  return this->Problem.empty();
}

void vtkAssemblyIndex::SetMemoryLimit(vtkTypeInt64 bytes)
{
  const vtkTypeInt64 before = this->MemoryLimit;
  vitrine::SetInRange(this, "MemoryLimit", this->MemoryLimit, bytes,
    vitrine::NumberRange<vtkTypeInt64>{ 0, VTK_TYPE_INT64_MAX });
  const std::size_t budget = this->MemoryLimit > 0 ? static_cast<std::size_t>(this->MemoryLimit)
                                                   : vitrine::MeshStore::Unlimited;
  if (!this->Answers([&] { this->Private->SetMemoryBudget(budget); }))
  {
    this->MemoryLimit = before;
  }
}

std::string vtkAssemblyIndex::GetProblem()
{
  return this->Problem;
}

int vtkAssemblyIndex::AddPart(vtkPolyData* geometry, vtkMatrix4x4* place, const std::string& name)
{
  if (!geometry)
  {
    vtkErrorMacro(<< "A part needs a geometry.");
    return -1;
  }
  int part = -1;
  this->Answers([&] { part = this->Private->Add(geometry, place, name, nullptr, 0); });
  return part;
}

void vtkAssemblyIndex::AddAssembly(vtkAssemblyActors* actors)
{
  this->Answers(
    [&]
    {
      for (int part = 0; actors && part < actors->GetNumberOfParts(); ++part)
      {
        this->Private->Add(actors->GetPartGeometry(part), actors->GetPartPlace(part),
          actors->GetPartName(part), actors->GetPartActor(part), actors->GetPartBlock(part));
      }
    });
}

int vtkAssemblyIndex::AddActors(vtkRenderer* renderer)
{
  if (!this->IsThere(renderer))
  {
    return 0;
  }
  int leftOut = 0;
  this->Answers([&] { leftOut = this->AddPropsOf(renderer); });
  return leftOut;
}

int vtkAssemblyIndex::AddPropsOf(vtkRenderer* renderer)
{
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
  const std::map<unsigned int, std::string> names = vitrine::BlockNames(vitrine::BlocksOf(actor));
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
  return this->Private->Count();
}

std::string vtkAssemblyIndex::GetPartName(int part)
{
  return this->IsPart(part) ? this->Private->Part(part).Name : std::string();
}

int vtkAssemblyIndex::GetPartNumberOfTriangles(int part)
{
  std::uint32_t count = 0;
  if (this->IsPart(part))
  {
    this->Answers([&] { count = this->Private->Placed(part).Mesh().TriangleCount(); });
  }
  return static_cast<int>(count);
}

bool vtkAssemblyIndex::GetPartIsClosed(int part)
{
  bool isClosed = false;
  return this->IsPart(part) &&
    this->Answers([&] { isClosed = this->Private->Placed(part).IsClosed(); }) && isClosed;
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
  vitrine::Ray ray;
  std::vector<vitrine::IndexedCrossing> found;
  const bool isAnswered = this->TakeRay(origin, direction, length, ray) &&
    this->Answers([&] { found = this->Private->Crossings(ray); });
  vitrine::WriteCrossings(crossings, ray, found);
  return isAnswered;
}

bool vtkAssemblyIndex::FindWalls(
  const double origin[3], const double direction[3], double length, vtkTable* walls)
{
  if (!this->IsThere(walls))
  {
    return false;
  }
  vitrine::Ray ray;
  std::vector<vitrine::Wall> found;
  const bool isAnswered = this->TakeRay(origin, direction, length, ray) &&
    this->Answers([&] { found = this->Private->Built().Walls(ray); });
  vitrine::WriteWalls(walls, found);
  return isAnswered;
}

int vtkAssemblyIndex::FindNearest(const double point[3], double nearest[3])
{
  if (!AreFinite(point, 3))
  {
    vtkErrorMacro(<< "Nothing is nearest to a point that has a number that is not finite.");
    return -1;
  }
  std::optional<vitrine::NearPart> near;
  this->Answers([&] { near = this->Private->Built().Nearest(VectorOf(point)); });
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
  return this->Answers(
    [&]
    {
      const vitrine::AssemblyIndex& index = this->Private->Built();
      Fill(parts, isWholly ? index.PartsWithin(box) : index.PartsTouching(box));
    });
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
  return this->Answers(
    [&]
    {
      const vitrine::AssemblyIndex& index = this->Private->Built();
      Fill(
        parts, isWholly ? index.PartsWithin(middle, radius) : index.PartsTouching(middle, radius));
    });
}

double vtkAssemblyIndex::GetDistance(int first, int second, double onFirst[3], double onSecond[3])
{
  if (!this->IsPart(first) || !this->IsPart(second))
  {
    return -1.0;
  }
  std::optional<vitrine::Gap> gap;
  const bool isAnswered = this->Answers(
    [&]
    {
      gap = this->Private->Index().Distance(
        static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second));
    });
  if (!isAnswered)
  {
    return -1.0;
  }
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
  const vitrine::WideBox& bounds = this->Private->Index().Bounds();
  return bounds.IsEmpty() ? 0.0 : glm::length(bounds.High - bounds.Low) / 1000.0;
}

bool vtkAssemblyIndex::FindClashes(double clearance, double tolerance, vtkTable* clashes)
{
  if (!this->IsThere(clashes))
  {
    return false;
  }
  const double limits[2] = { clearance, tolerance };
  if (!AreFinite(limits, 2) || clearance < 0.0 || tolerance < 0.0)
  {
    vtkErrorMacro(<< "Clearance and tolerance are finite numbers from 0 up, not " << clearance
                  << " and " << tolerance << ".");
    vitrine::WriteClashes(clashes, {});
    return false;
  }
  this->AbortExecute = 0;
  const auto goesOn = [this](double done)
  {
    this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    return this->AbortExecute == 0;
  };
  std::vector<vitrine::Clash> found;
  const bool isAnswered = this->Answers(
    [&] {
      found = this->Private->Index().Clashes({ clearance, tolerance }, goesOn);
    });
  vitrine::WriteClashes(clashes, found);
  return isAnswered && goesOn(1.0);
}

bool vtkAssemblyIndex::MaySee(int first, int second, vtkIdList* through)
{
  if (!this->IsPart(first) || !this->IsPart(second))
  {
    return false;
  }
  bool maySee = true;
  this->Answers(
    [&]
    {
      maySee = this->Private->Built().MaySee(static_cast<std::uint32_t>(first),
        static_cast<std::uint32_t>(second),
        [through](std::uint32_t part)
        { return !through || through->IsId(static_cast<vtkIdType>(part)) < 0; });
    });
  return maySee;
}
