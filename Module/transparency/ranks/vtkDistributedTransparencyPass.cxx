#include "vtkDistributedTransparencyPass.h"

#include "Core/lists/ScreenBands.h"
#include "Core/ranks/SentLists.h"
#include "Core/ranks/TileOwners.h"
#include "Shaders/SharedLayout.h"
#include "gl/RenderTarget.h"
#include "gl/StageTimer.h"
#include "scene/PassTraits.h"
#include "scene/Settings.h"
#include "transparency/abuffer/PackedListStore.h"
#include "transparency/common/CoincidenceTolerance.h"
#include "transparency/ranks/FrameFacts.h"
#include "transparency/ranks/GhostCells.h"
#include "transparency/ranks/RankCamera.h"
#include "transparency/ranks/RankExchange.h"
#include "transparency/ranks/RankPicture.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkDistributedTransparencyPass);
vitrinePassTraitsMacro(vtkDistributedTransparencyPass, vitrine::TranslucentTraits);

namespace
{

const char* const DrawnAgain = "fragments are added to what is behind them";

}

struct vtkDistributedTransparencyPass::Shared
{
  vitrine::RankExchange Exchange;
  vitrine::GhostCells Ghosts;
  std::string GhostProblem; // of this frame
  std::unique_ptr<vitrine::PackedListStore>
    Received = // The lists of the pixels that this rank owns.
    std::make_unique<vitrine::PackedListStore>();
  vitrine::RankPicture Picture;
  vitrine::TileOwners Owners;        // of the frame's region
  vitrine::PixelLists Own;           // The lists that this rank drew last.
  vitrine::PixelLists Joined;        // The lists of all ranks of the pixels that this rank owns.
  bool IsTooLarge = false;           // This rank's lists are not all in its store.
  vitrine::FragmentStatistics Owned; // The numbers of the lists that were composited here.
  bool HasJoined = false;            // The ranks have agreed whether to draw the frame.
  bool HasCombined = false;          // The target has the nearest opaque pixels of all ranks.
  bool HasAgreed = false;            // The ranks have agreed whether there are lists.
  std::string Problem;               // Why no rank draws the frame.
  vitrine::Bounds Bounds{};          // What ComputeVisiblePropBounds() found last.
};

//------------------------------------------------------------------------------
vtkDistributedTransparencyPass::vtkDistributedTransparencyPass()
  : Ranks(new Shared)
{
}

//------------------------------------------------------------------------------
vtkDistributedTransparencyPass::~vtkDistributedTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->GetController() << "\n";
  os << indent << "PictureRank: " << this->PictureRank << "\n";
  os << indent << "SentFragments: " << this->SentFragments << "\n";
  os << indent << "SentFragmentBytes: " << this->SentFragmentBytes << "\n";
  os << indent << "SentOtherBytes: " << this->SentOtherBytes << "\n";
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::SetController(vtkMultiProcessController* controller)
{
  const bool isOther = controller != this->GetController();
  this->Ranks->Exchange.SetController(controller); // which forgets a failure of the same one
  if (isOther)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkDistributedTransparencyPass::GetController()
{
  return this->Ranks->Exchange.Controller();
}

//------------------------------------------------------------------------------
int vtkDistributedTransparencyPass::GetNumberOfRanks()
{
  return this->Ranks->Exchange.Count();
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::SetPictureRank(int rank)
{
  vitrine::SetInRange(
    this, "PictureRank", this->PictureRank, rank, { -1, std::numeric_limits<int>::max() });
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::ResetCamera(vtkRenderer* renderer)
{
  vitrine::RankExchange& ranks = this->Ranks->Exchange;
  const vitrine::Bounds bounds = vitrine::BoundsOfRanks(ranks, renderer);
  renderer->ResetCamera(bounds.data());
  vitrine::ShareCamera(ranks, renderer, bounds);
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::SynchronizeCamera(vtkRenderer* renderer)
{
  vitrine::RankExchange& ranks = this->Ranks->Exchange;
  vitrine::ShareCamera(ranks, renderer, vitrine::BoundsOfRanks(ranks, renderer));
}

//------------------------------------------------------------------------------
double* vtkDistributedTransparencyPass::ComputeVisiblePropBounds(vtkRenderer* renderer)
{
  this->Ranks->Bounds = vitrine::BoundsOfRanks(this->Ranks->Exchange, renderer);
  return this->Ranks->Bounds.data();
}

//------------------------------------------------------------------------------
int vtkDistributedTransparencyPass::GetNodeBytes()
{
  return this->GetLayout().NodeBytes();
}

//------------------------------------------------------------------------------
bool vtkDistributedTransparencyPass::HasFragments(const vtkRenderState* s)
{
  return this->Ranks->Exchange.Count() > 1 || this->Superclass::HasFragments(s);
}

//------------------------------------------------------------------------------
// No other method draws the geometry of several ranks.
std::string vtkDistributedTransparencyPass::GetSubstituteName()
{
  return this->Ranks->Exchange.Count() > 1 ? std::string() : this->Superclass::GetSubstituteName();
}

//------------------------------------------------------------------------------
// A rank that does not come as far as the others tells them why, since they wait for it.
void vtkDistributedTransparencyPass::Render(const vtkRenderState* s)
{
  Shared& r = *this->Ranks;
  if (r.Exchange.Count() == 1)
  {
    this->Superclass::Render(s);
    return;
  }
  r.HasJoined = false;
  r.HasCombined = false;
  r.Problem.clear();
  r.Owned = {};
  r.Exchange.ResetBytes();
  this->SentFragments = 0;
  this->SentFragmentBytes = 0;
  // A pass that changes its window forgets the stand-ins within the frame.
  const std::vector<vtkSmartPointer<vtkProp>> held = r.Ghosts.WithoutThem(s);
  r.GhostProblem = r.Ghosts.Problem();
  std::vector<vtkProp*> props(held.begin(), held.end());
  vtkRenderState own(s->GetRenderer());
  own.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  own.SetFrameBuffer(s->GetFrameBuffer());
  own.SetRequiredKeys(s->GetRequiredKeys());
  this->Superclass::Render(&own);
  if (!r.HasJoined)
  {
    const std::string reason = this->GetFallbackReason();
    this->TellReason(r.Exchange.Agree(reason.empty() ? "the renderer has no pixels" : reason));
  }
  this->SentOtherBytes = r.Exchange.BytesSent() - this->SentFragmentBytes;
}

//------------------------------------------------------------------------------
// The superclass tries another text of the shaders if a driver refuses one. The other ranks do not wait for that.
std::string vtkDistributedTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Shared& r = *this->Ranks;
  if (r.Exchange.Count() == 1)
  {
    return this->Superclass::RenderFragments(s, target);
  }
  if (r.Problem.empty())
  {
    const std::string problem = this->DrawTogether(s, target);
    if (problem == DrawnAgain)
    {
      return problem; // by all ranks, with other shaders
    }
    r.Problem = problem;
  }
  return r.Problem;
}

//------------------------------------------------------------------------------
// Opaque pixels are combined once, also if the frame is drawn again with other shaders.
std::string vtkDistributedTransparencyPass::DrawTogether(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Shared& r = *this->Ranks;
  std::string problem = r.HasCombined ? std::string() : this->Join(s, target);
  if (!problem.empty())
  {
    return problem;
  }
  r.HasAgreed = false;
  problem = r.HasCombined ? std::string() : this->CombineOpaque(target);
  if (problem.empty())
  {
    problem = this->Superclass::RenderFragments(s, target);
  }
  if (!r.HasAgreed) // This rank has failed before RenderLists().
  {
    problem = this->AgreeOnLists(problem);
  }
  if (problem == DrawnAgain)
  {
    return problem;
  }
  problem = r.Problem.empty() ? this->SendPicture(target, problem) : r.Problem;
  if (!problem.empty())
  {
    r.Picture.PutBack(this->GetWindow(), target);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkDistributedTransparencyPass::CombineOpaque(const vitrine::RenderTarget& target)
{
  Shared& r = *this->Ranks;
  const vitrine::StageTimer::Section section(this->GetStageTimer(), "opaque");
  if (!r.Owners.Divide(target.Region, target.Width, r.Exchange.Count()))
  {
    r.Owners = vitrine::TileOwners(target.Region, target.Width, r.Exchange.Count());
  }
  r.HasCombined = true;
  return r.Picture.CombineOpaque(r.Exchange, r.Owners, this->GetWindow(), target);
}

//------------------------------------------------------------------------------
// Returns why this rank cannot draw a frame with others, or an empty string.
std::string vtkDistributedTransparencyPass::FindHindrance(vtkRenderer* renderer)
{
  const Shared& r = *this->Ranks;
  if (this->PictureRank >= r.Exchange.Count())
  {
    return "the picture is for rank " + std::to_string(this->PictureRank) + " of " +
      std::to_string(r.Exchange.Count());
  }
  if (renderer->GetUseSSAO() || renderer->GetUseShadows())
  {
    return "ambient occlusion and shadows see the geometry of one rank alone; call UseSSAOOff() "
           "and UseShadowsOff()";
  }
  if (renderer->GetPreserveDepthBuffer() && this->PictureRank >= 0)
  {
    return "the renderer preserves the depth of pixels that another rank has; call "
           "SetPictureRank(-1)";
  }
  return r.GhostProblem;
}

//------------------------------------------------------------------------------
// Returns why the ranks cannot draw a frame together, the same on all of them.
std::string vtkDistributedTransparencyPass::Join(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Shared& r = *this->Ranks;
  r.HasJoined = true;
  const std::string problem = r.Exchange.Agree(this->FindHindrance(s->GetRenderer()));
  if (!problem.empty())
  {
    return problem;
  }
  for (const std::vector<std::uint64_t>& told :
    r.Exchange.GatherNumbers({ this->HasAdditiveFragments() ? 1u : 0u }))
  {
    if (told[0] > 0)
    {
      this->ExpectAdditiveFragments();
    }
  }
  const vitrine::CoincidenceTolerance tolerance = this->GetTolerance();
  vitrine::FrameFacts facts;
  facts.Width = target.Width;
  facts.Height = target.Height;
  facts.Region = target.Region;
  facts.Samples = target.Samples;
  facts.ColorFormat = target.Color.InternalFormat;
  facts.DepthFormat = target.Depth.InternalFormat;
  facts.ColorStorage = this->ColorStorage;
  facts.PictureRank = this->PictureRank;
  facts.ToleranceSteps = tolerance.Steps;
  facts.ToleranceSlope = tolerance.Slope;
  facts.Matrices = vitrine::ViewMatricesOf(s->GetRenderer());
  facts.Look = vitrine::LookOf(s->GetRenderer());
  const std::string difference =
    vitrine::FindDifference(r.Exchange.GatherAll(vitrine::MessageOf(facts)));
  return r.Exchange.Failure().empty() ? difference : r.Exchange.Failure();
}

//------------------------------------------------------------------------------
std::string vtkDistributedTransparencyPass::RenderLists(
  const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::FragmentStatistics& frame)
{
  Shared& r = *this->Ranks;
  if (r.Exchange.Count() == 1)
  {
    return this->Superclass::RenderLists(s, target, frame);
  }
  vtkOpenGLState* const state = this->GetWindow()->GetState();
  vitrine::ListLayout layout = this->GetLayout();
  std::string problem = r.Received->BeginFrame(state, target, this->MemoryLimit, layout);
  if (problem.empty())
  {
    problem = this->FillLists(s, target, target.Region, frame, r.IsTooLarge);
  }
  if (problem.empty())
  {
    static_cast<vitrine::PackedListStore&>(this->GetStore()).Read(state, r.Own);
  }
  problem = this->AgreeOnLists(problem);
  if (!problem.empty())
  {
    return problem;
  }
  return this->FitsInOnePiece() ? this->JoinLists(target, target.Region)
                                : this->RenderBands(s, target);
}

//------------------------------------------------------------------------------
// Returns why there are no lists, the same on all ranks. Fragments that one rank adds are shaded as such by all.
std::string vtkDistributedTransparencyPass::AgreeOnLists(const std::string& problem)
{
  Shared& r = *this->Ranks;
  r.HasAgreed = true;
  const bool adds = this->DrewAdditiveFragments();
  bool isAnyAdded = false;
  for (const std::vector<std::uint64_t>& numbers : r.Exchange.GatherNumbers({ adds ? 1u : 0u }))
  {
    isAnyAdded = isAnyAdded || numbers[0] > 0;
  }
  if (isAnyAdded)
  {
    this->NoteAdditiveFragments();
  }
  const bool isDrawnAgain = isAnyAdded && !this->HasAdditiveFragments();
  r.Problem = r.Exchange.Agree(adds && isDrawnAgain ? std::string() : problem);
  return r.Problem.empty() && isDrawnAgain ? DrawnAgain : r.Problem;
}

//------------------------------------------------------------------------------
// Returns whether all ranks have room for the lists that they drew and for those that they own. All find the same.
bool vtkDistributedTransparencyPass::FitsInOnePiece()
{
  Shared& r = *this->Ranks;
  const int count = r.Exchange.Count();
  std::vector<std::uint64_t> numbers;
  for (int owner = 0; owner < count; ++owner)
  {
    numbers.push_back(vitrine::CountNodes(r.Own, r.Owners.PixelsOf(owner)));
  }
  numbers.push_back(static_cast<std::uint64_t>(r.Received->CapacityUnits()));
  numbers.push_back(r.IsTooLarge ? 1u : 0u);
  const std::vector<std::vector<std::uint64_t>> all = r.Exchange.GatherNumbers(numbers);
  bool fits = true;
  for (int owner = 0; owner < count; ++owner)
  {
    std::uint64_t owned = 0;
    for (const std::vector<std::uint64_t>& told : all)
    {
      owned += told[owner];
    }
    fits = fits && owned <= all[owner][count] && all[owner][count + 1] == 0;
  }
  return fits;
}

//------------------------------------------------------------------------------
// Draws bands of which no rank has more fragments than the rank with the least memory can hold.
std::string vtkDistributedTransparencyPass::RenderBands(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Shared& r = *this->Ranks;
  const std::vector<std::uint32_t> needs = r.Exchange.Sums(r.Own.Counts);
  const std::uint64_t capacity = r.Exchange.Least(static_cast<std::uint64_t>(
    std::min(r.Received->CapacityUnits(), this->GetStore().CapacityUnits())));
  const vitrine::BandPlan plan =
    vitrine::PlanBands(needs, target.Width, target.Height, capacity, target.Region);
  if (!plan.Fits)
  {
    r.Problem = "one pixel alone has " + std::to_string(plan.LargestPixel) +
      " fragments of all ranks, and the rank with the least memory has room for " +
      std::to_string(capacity) + "; give SetMemoryLimit() more";
    return r.Problem;
  }
  for (const vitrine::PixelRegion& band : plan.Bands)
  {
    vitrine::FragmentStatistics part;
    std::string problem = this->FillLists(s, target, band, part, r.IsTooLarge);
    if (problem.empty() && r.IsTooLarge)
    {
      problem =
        "the translucent props make more fragments each time they are drawn within one frame";
    }
    r.Problem = r.Exchange.Agree(problem);
    if (!r.Problem.empty())
    {
      return r.Problem;
    }
    static_cast<vitrine::PackedListStore&>(this->GetStore())
      .Read(this->GetWindow()->GetState(), r.Own);
    problem = this->JoinLists(target, band);
    r.Problem = r.Exchange.Agree(problem);
    if (!r.Problem.empty())
    {
      return r.Problem;
    }
  }
  this->NumberOfBands = static_cast<int>(plan.Bands.size());
  return {};
}

//------------------------------------------------------------------------------
// Sends the lists of a region to the owners of its pixels, and composites those that this rank owns.
std::string vtkDistributedTransparencyPass::JoinLists(
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region)
{
  Shared& r = *this->Ranks;
  const int own = r.Exchange.Rank();
  const bool isBand = !(region == target.Region);
  const vitrine::TileOwners ownersOfBand =
    isBand ? vitrine::TileOwners(region, target.Width, r.Exchange.Count()) : vitrine::TileOwners();
  const vitrine::TileOwners& owners = isBand ? ownersOfBand : r.Owners;
  std::vector<vitrine::Message> messages(r.Exchange.Count());
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "send");
    for (int rank = 0; rank < r.Exchange.Count(); ++rank)
    {
      if (rank != own)
      {
        vitrine::PackLists(r.Own, owners.PixelsOf(rank), messages[rank]);
        this->SentFragments +=
          static_cast<vtkTypeInt64>(vitrine::CountNodes(r.Own, owners.PixelsOf(rank)));
      }
    }
    const std::int64_t before = r.Exchange.BytesSent();
    messages = r.Exchange.Exchange(std::move(messages));
    this->SentFragmentBytes += r.Exchange.BytesSent() - before;
  }
  if (!r.Exchange.Failure().empty())
  {
    return r.Exchange.Failure();
  }
  std::string problem =
    vitrine::JoinLists(r.Own, owners.PixelsOf(own), messages, VITRINE_LARGEST_COUNT, r.Joined);
  if (problem.empty())
  {
    problem = r.Received->Load(this->GetWindow()->GetState(), region, r.Joined);
  }
  vitrine::FragmentStatistics part;
  if (problem.empty())
  {
    problem = this->CompositeLists(*r.Received, target, region, part);
  }
  r.Owned.Add(part);
  return problem;
}

//------------------------------------------------------------------------------
// Sends the tiles that this rank owns to the rank that wants the picture. Returns why that failed, the same on all.
std::string vtkDistributedTransparencyPass::SendPicture(
  const vitrine::RenderTarget& target, const std::string& problem)
{
  Shared& r = *this->Ranks;
  const std::string agreed = r.Exchange.Agree(problem);
  if (!agreed.empty())
  {
    return agreed;
  }
  this->TakeTotals();
  const vitrine::StageTimer::Section section(this->GetStageTimer(), "picture");
  return r.Exchange.Agree(
    r.Picture.Send(r.Exchange, r.Owners, this->GetWindow(), target, this->PictureRank));
}

//------------------------------------------------------------------------------
// Sets the numbers of the frame to those of all ranks.
void vtkDistributedTransparencyPass::TakeTotals()
{
  Shared& r = *this->Ranks;
  r.Received->EndFrame(r.Owned, this->NumberOfBands);
  vitrine::FragmentStatistics all;
  for (const std::vector<std::uint64_t>& told :
    r.Exchange.GatherNumbers({ std::uint64_t(r.Owned.Fragments), std::uint64_t(r.Owned.LayersMax),
      std::uint64_t(r.Owned.CoveredPixels) }))
  {
    vitrine::FragmentStatistics part;
    part.Fragments = static_cast<std::int64_t>(told[0]);
    part.LayersMax = static_cast<std::int64_t>(told[1]);
    part.CoveredPixels = static_cast<std::int64_t>(told[2]);
    all.Add(part);
  }
  this->NumberOfFragments = all.Fragments;
  this->MaximumNumberOfLayers = all.LayersMax;
  this->MeanNumberOfLayers = all.CoveredPixels > 0
    ? static_cast<double>(all.Fragments) / static_cast<double>(all.CoveredPixels)
    : 0.0;
  this->Bytes += r.Received->NodeBytes() + r.Received->OtherBytes() + r.Picture.Bytes();
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::ReleaseMethodResources()
{
  this->Ranks->Received->Release();
  this->Ranks->Picture.Release();
  this->ForgetFrame();
  this->Superclass::ReleaseMethodResources();
}

//------------------------------------------------------------------------------
void vtkDistributedTransparencyPass::ForgetMethodResources()
{
  this->ForgetFrame();
  this->Superclass::ForgetMethodResources();
}

//------------------------------------------------------------------------------
// Frees what the last frame left in memory.
void vtkDistributedTransparencyPass::ForgetFrame()
{
  Shared& r = *this->Ranks;
  r.Received = std::make_unique<vitrine::PackedListStore>();
  r.Picture = vitrine::RankPicture();
  r.Ghosts = vitrine::GhostCells();
  r.Owners = vitrine::TileOwners();
  r.Own = {};
  r.Joined = {};
}
