#include "vtkPartLevels.h"

#include "assembly/CoarseActors.h"
#include "assembly/PartDetail.h"
#include "scene/AnswerEvent.h"
#include "scene/ExactParts.h"
#include "scene/FrameObserver.h"
#include "scene/Settings.h"
#include "vtkAssemblyActors.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkPartLevels);

namespace
{

using vitrine::CoarseActors;
using vitrine::DetailWork;
using vitrine::LevelCounts;
using vitrine::LevelRequest;
using vitrine::PixelView;

/** Event by which a renderer's observers are asked for the levels that are attached to it. */
constexpr unsigned long AskForLevels = vtkCommand::UserEvent + 0x56495464;

void TellLevels(vtkObject*, unsigned long, void* levels, void* asked)
{
  *static_cast<vtkPartLevels**>(asked) = static_cast<vtkPartLevels*>(levels);
}

void TellStandIns(vtkObject*, unsigned long, void* standIns, void* asked)
{
  *static_cast<const vitrine::StandIns**>(asked) = static_cast<const vitrine::StandIns*>(standIns);
}

/** All that a camera has to be alike in, so that it stands still. */
using Standpoint = std::array<double, 12>;

Standpoint StandpointOf(vtkCamera* camera)
{
  Standpoint point{};
  camera->GetPosition(point.data());
  camera->GetFocalPoint(point.data() + 3);
  camera->GetViewUp(point.data() + 6);
  point[9] = camera->GetViewAngle();
  point[10] = camera->GetParallelScale();
  point[11] = camera->GetParallelProjection();
  return point;
}

/** Returns true if a frame is a tile of a larger picture, which has a camera of its own. */
bool IsTile(vtkRenderer* renderer)
{
  const int* const tiles = renderer->GetVTKWindow()->GetTileScale();
  return tiles[0] > 1 || tiles[1] > 1;
}

/**
 * Returns true if a camera is described by its position, its directions, and its angle or scale alone: it has no matrix
 * of its own that could make lengths longer.
 */
bool IsPlain(vtkCamera* camera)
{
  const auto isIdentity = [](vtkHomogeneousTransform* transform)
  { return !transform || transform->GetMatrix()->IsIdentity(); };
  return !camera->GetUseExplicitProjectionTransformMatrix() &&
    camera->GetModelTransformMatrix()->IsIdentity() && isIdentity(camera->GetUserTransform()) &&
    isIdentity(camera->GetUserViewTransform());
}

PixelView PixelViewOf(vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  const int* const size = renderer->GetSize();
  PixelView view;
  view.IsParallel = camera->GetParallelProjection() != 0;
  camera->GetPosition(&view.Eye.x);
  camera->GetDirectionOfProjection(&view.Direction.x);
  view.Nearest = camera->GetClippingRange()[0];
  view.Width = std::max(size[0], 1);
  view.Height = std::max(size[1], 1);
  view.HalfTangent = std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  if (camera->GetUseHorizontalViewAngle())
  {
    view.HalfTangent *= view.Height / view.Width;
  }
  view.ParallelHeight = 2 * camera->GetParallelScale();
  return view;
}

/** Adds the planes before and behind which nothing is drawn. */
void AddClippingPlanes(vtkCamera* camera, std::vector<vitrine::CutPlane>& planes)
{
  glm::dvec3 eye, direction;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&direction.x);
  for (const double distance : { camera->GetClippingRange()[0], camera->GetClippingRange()[1] })
  {
    planes.push_back({ direction, -glm::dot(direction, eye) - distance });
  }
}

}

struct vtkPartLevels::Internals
{
  /**
   * Where looks change in each frame, as while parts are revealed, new actors would be made for each. So after actors
   * that lasted for one frame only, some frames are drawn without. Those are twice as many each time.
   */
  class MakingDelay
  {
  public:
    bool IsOver() const { return this->Frames == 0; }
    void CountFrame() { --this->Frames; }

    /** Actors are made. */
    void Begin()
    {
      this->Frames = this->Next;
      this->Next = std::min(2 * this->Next + 1, Longest);
    }

    /** Actors have lasted. */
    void End() { *this = {}; }

  private:
    static constexpr int Longest = 31;

    int Frames = 0;
    int Next = 0;
  };

  /** An assembly, the work on its levels, and the actors that draw them once they are made. */
  struct LevelledAssembly
  {
    vtkSmartPointer<vtkAssemblyActors> Parts;
    std::unique_ptr<DetailWork> Work;
    std::unique_ptr<CoarseActors> Coarse;
    vtkMTimeType Time = 0; ///< when geometry had changed last as the actors were made
    MakingDelay Delay;

    bool IsOutdated() const
    {
      return !this->Coarse || this->Coarse->AreOutdated(this->Parts->Drawn()) ||
        this->Work->TimeOfChange() > this->Time;
    }
  };

  std::vector<LevelledAssembly> Assemblies;
  double Pixels = 0.5;
  bool ExactWhileStill = true;
  bool UseCache = true;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vitrine::FrameObserver> Observer;
  unsigned long Answers[2]{};
  unsigned long Deletion = 0;     ///< observer of the renderer's end
  std::optional<Standpoint> Last; ///< of the frame before, if there was one
  vitrine::StandIns
    StandIns; ///< of the frame that is drawn: coarse actors, and those of assemblies that they replace
  bool DrewLevels = false;
  LevelCounts Counts;

  void StartFrame()
  {
    this->EndFrame();
    vtkRenderer* const renderer = this->Renderer;
    const bool isStill = this->IsStill();
    this->Counts = {};
    this->DrewLevels = false;
    if ((isStill && this->ExactWhileStill) || IsExactFor(renderer))
    {
      this->CountWhole();
      return;
    }
    LevelRequest asked{ PixelViewOf(renderer), this->Pixels, vitrine::ExactPartsOf(renderer) };
    AddClippingPlanes(renderer->GetActiveCamera(), asked.Exact.Planes);
    for (LevelledAssembly& assembly : this->Assemblies)
    {
      if (assembly.Work->IsDone())
      {
        this->Show(assembly, asked);
      }
    }
  }

  /** Returns true if the camera is that of the frame before. The size of the picture does not count. */
  bool IsStill()
  {
    if (IsTile(this->Renderer))
    {
      return true; // and no frame that the next one is compared with
    }
    const Standpoint standpoint = StandpointOf(this->Renderer->GetActiveCamera());
    const bool isStill = !this->Last || standpoint == *this->Last;
    this->Last = standpoint;
    return isStill;
  }

  /** Returns true if a frame has to be drawn as it is. */
  static bool IsExactFor(vtkRenderer* renderer)
  {
    return renderer->GetSelector() != nullptr || !IsPlain(renderer->GetActiveCamera());
  }

  void Show(LevelledAssembly& assembly, const LevelRequest& asked)
  {
    vtkRenderer* const renderer = this->Renderer;
    const bool isOutdated = assembly.IsOutdated();
    if (isOutdated && !assembly.Delay.IsOver())
    {
      assembly.Delay.CountFrame();
      this->Remove(assembly);
      return;
    }
    if (isOutdated)
    {
      this->Make(assembly);
      assembly.Delay.Begin();
    }
    else
    {
      assembly.Delay.End();
    }
    if (!assembly.Coarse->AreReplacedIn(renderer))
    {
      return; // the assembly, or some of it, is not shown here
    }
    assembly.Coarse->Choose(asked);
    if (assembly.Coarse->Counts().GreatestPixels > this->Pixels)
    {
      return; // single precision is too coarse here
    }
    assembly.Coarse->BeginFrame(asked.Exact.Props, this->StandIns);
    const LevelCounts& counts = assembly.Coarse->Counts();
    this->Counts.Triangles += counts.Triangles;
    this->Counts.WholeTriangles += counts.WholeTriangles;
    this->Counts.GreatestPixels = std::max(this->Counts.GreatestPixels, counts.GreatestPixels);
    this->DrewLevels = true;
  }

  void Make(LevelledAssembly& assembly)
  {
    this->Remove(assembly);
    assembly.Time = assembly.Work->TimeOfChange();
    assembly.Coarse = std::make_unique<CoarseActors>(
      assembly.Parts->Drawn(), [&](vtkPolyData* geometry) { return assembly.Work->Of(geometry); });
    for (vtkActor* const actor : assembly.Coarse->Actors())
    {
      this->Renderer->AddActor(actor);
    }
  }

  /** Counts the triangles of a frame without levels. */
  void CountWhole()
  {
    for (const LevelledAssembly& assembly : this->Assemblies)
    {
      if (assembly.Coarse)
      {
        this->Counts.WholeTriangles += assembly.Coarse->Counts().WholeTriangles;
      }
    }
    this->Counts.Triangles = this->Counts.WholeTriangles;
  }

  void EndFrame()
  {
    for (LevelledAssembly& assembly : this->Assemblies)
    {
      if (assembly.Coarse && !this->StandIns.Shown.empty())
      {
        assembly.Coarse->EndFrame(this->StandIns);
      }
    }
    this->StandIns = {};
  }

  void Remove(LevelledAssembly& assembly)
  {
    vtkRenderer* const renderer = this->Renderer;
    for (vtkActor* const actor :
      assembly.Coarse ? assembly.Coarse->Actors() : std::vector<vtkSmartPointer<vtkActor>>())
    {
      if (renderer)
      {
        renderer->RemoveActor(actor);
      }
    }
    assembly.Coarse.reset();
  }

  void RemoveAll()
  {
    this->EndFrame();
    for (LevelledAssembly& assembly : this->Assemblies)
    {
      this->Remove(assembly);
    }
  }
};

//------------------------------------------------------------------------------
vtkPartLevels::vtkPartLevels()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
// A renderer to which the object is attached keeps it alive. So there is none, or it is being deleted.
vtkPartLevels::~vtkPartLevels()
{
  this->Private->EndFrame();
}

//------------------------------------------------------------------------------
void vtkPartLevels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pixels: " << this->GetPixels() << "\n";
  os << indent << "ExactWhileStill: " << this->GetExactWhileStill() << "\n";
  os << indent << "UseCache: " << this->GetUseCache() << "\n";
  os << indent << "Progress: " << this->GetProgress() << "\n";
}

//------------------------------------------------------------------------------
void vtkPartLevels::AddAssembly(vtkAssemblyActors* assembly)
{
  if (!assembly)
  {
    vtkErrorMacro("AddAssembly() takes the actors of an assembly");
    return;
  }
  auto& assemblies = this->Private->Assemblies;
  if (std::any_of(assemblies.begin(), assemblies.end(),
        [&](const Internals::LevelledAssembly& known) { return known.Parts == assembly; }))
  {
    return;
  }
  DetailWork::Geometries geometries;
  std::set<vtkPolyData*> known;
  for (int part = 0; part < assembly->GetNumberOfParts(); ++part)
  {
    vtkPolyData* const geometry = assembly->GetPartGeometry(part);
    if (vitrine::HasTrianglesAlone(geometry) && known.insert(geometry).second)
    {
      geometries.emplace_back(geometry);
    }
  }
  assemblies.push_back({ assembly,
    std::make_unique<DetailWork>(std::move(geometries), this->Private->UseCache), nullptr, 0, {} });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPartLevels::SetPixels(double pixels)
{
  vitrine::SetInRange(
    this, "Pixels", this->Private->Pixels, pixels, vitrine::NumberRange<double>{ 0.001, 64.0 });
}

//------------------------------------------------------------------------------
double vtkPartLevels::GetPixels()
{
  return this->Private->Pixels;
}

//------------------------------------------------------------------------------
void vtkPartLevels::SetExactWhileStill(bool exact)
{
  if (this->Private->ExactWhileStill != exact)
  {
    this->Private->ExactWhileStill = exact;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPartLevels::GetExactWhileStill()
{
  return this->Private->ExactWhileStill;
}

//------------------------------------------------------------------------------
void vtkPartLevels::SetUseCache(bool use)
{
  if (this->Private->UseCache != use)
  {
    this->Private->UseCache = use;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPartLevels::GetUseCache()
{
  return this->Private->UseCache;
}

//------------------------------------------------------------------------------
void vtkPartLevels::Attach(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkPartLevels> alive = this;
  this->Detach();
  if (!renderer)
  {
    vtkErrorMacro("Attach() takes a renderer");
    return;
  }
  if (vtkPartLevels* const other = GetAttached(renderer))
  {
    other->Detach();
  }
  Internals& in = *this->Private;
  in.Renderer = renderer;
  in.Last.reset();
  in.Observer = vtkSmartPointer<vitrine::FrameObserver>::New();
  in.Observer->Start = [&in] { in.StartFrame(); };
  in.Observer->End = [&in] { in.EndFrame(); };
  in.Observer->Watch(
    renderer, this, vitrine::FollowsCamera); // before those that look which props there are
  in.Answers[0] = vitrine::AddAnswer(renderer, AskForLevels, TellLevels, this);
  in.Answers[1] = vitrine::AddAnswer(renderer, vitrine::AskForStandIns, TellStandIns, &in.StandIns);
  in.Deletion =
    renderer->AddObserver(vtkCommand::DeleteEvent, this, &vtkPartLevels::WhenRendererIsDeleted);
}

//------------------------------------------------------------------------------
void vtkPartLevels::Detach()
{
  Internals& in = *this->Private;
  in.RemoveAll();
  vtkRenderer* const renderer = in.Renderer; // It may be about to be deleted, so it is not held.
  in.Renderer = nullptr;
  if (renderer)
  {
    for (const unsigned long answer : in.Answers)
    {
      renderer->RemoveObserver(answer);
    }
    renderer->RemoveObserver(in.Deletion);
    const vtkSmartPointer<vitrine::FrameObserver> observer = std::move(in.Observer);
    observer->Leave(renderer); // it may hold the last reference to this object
  }
}

//------------------------------------------------------------------------------
void vtkPartLevels::WhenRendererIsDeleted()
{
  this->Private->EndFrame();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkPartLevels::GetRenderer()
{
  return this->Private->Renderer;
}

//------------------------------------------------------------------------------
vtkPartLevels* vtkPartLevels::GetAttached(vtkRenderer* renderer)
{
  vtkPartLevels* attached = nullptr;
  if (renderer)
  {
    renderer->InvokeEvent(AskForLevels, &attached);
  }
  return attached;
}

//------------------------------------------------------------------------------
double vtkPartLevels::GetProgress()
{
  std::size_t done = 0;
  std::size_t all = 0;
  for (const Internals::LevelledAssembly& assembly : this->Private->Assemblies)
  {
    done += assembly.Work->CountOfDone();
    all += assembly.Work->Count();
  }
  return all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
}

//------------------------------------------------------------------------------
void vtkPartLevels::WaitUntilMade()
{
  for (const Internals::LevelledAssembly& assembly : this->Private->Assemblies)
  {
    assembly.Work->Wait();
  }
}

//------------------------------------------------------------------------------
bool vtkPartLevels::GetDrewLevels()
{
  return this->Private->DrewLevels;
}

//------------------------------------------------------------------------------
vtkIdType vtkPartLevels::GetNumberOfTriangles()
{
  return static_cast<vtkIdType>(this->Private->Counts.Triangles);
}

//------------------------------------------------------------------------------
vtkIdType vtkPartLevels::GetNumberOfWholeTriangles()
{
  return static_cast<vtkIdType>(this->Private->Counts.WholeTriangles);
}

//------------------------------------------------------------------------------
double vtkPartLevels::GetGreatestDistance()
{
  return this->Private->Counts.GreatestPixels;
}
