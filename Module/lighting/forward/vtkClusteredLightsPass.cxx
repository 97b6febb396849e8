#include "vtkClusteredLightsPass.h"

#include "Core/lighting/LightAssignment.h"
#include "Core/lighting/LightCut.h"
#include "gl/Capabilities.h"
#include "gl/HeldContext.h"
#include "lighting/forward/LightBuffers.h"
#include "lighting/forward/LightLoop.h"
#include "lighting/forward/LightSwap.h"
#include "lighting/forward/MaterialGain.h"
#include "lighting/forward/RendererLights.h"
#include "lighting/forward/ViewGrid.h"
#include "lighting/forward/WorldCells.h"
#include "scene/LitProps.h"
#include "scene/PassTraits.h"
#include "scene/Settings.h"
#include "scene/VisibleBox.h"
#include "vtkAbstractMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkClusteredLightsPass);
vitrinePassTraitsMacro(vtkClusteredLightsPass, vitrine::LightsTraits<vtkClusteredLightsPass>);

struct vtkClusteredLightsPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  vitrine::RendererLights Lights;
  vitrine::LightFormula Formula = vitrine::LightFormula::None;
  vitrine::LightAssigner Assigner;
  vitrine::LightLists Lists;
  std::unique_ptr<vitrine::LightGrid> Grid;
  /** The grid of the statistics. ToldLists are its lists. */
  const vitrine::LightGrid* ToldGrid = nullptr;
  const vitrine::LightLists* ToldLists = nullptr;
  vitrine::LightBuffers Buffers;
  vitrine::HeldContext Context; ///< context of the buffers
  vtkSmartPointer<vtkLightCollection> Directional = vitrine::MakeStandIn(false);
  vtkSmartPointer<vtkLightCollection> Positional = vitrine::MakeStandIn(true);
  std::set<std::string> Reported;
  std::string FallbackReason;
  /** The boxes of each renderer's props. The address of a deleted renderer may belong to another one. */
  std::map<vtkRenderer*, std::pair<vtkWeakPointer<vtkRenderer>, vitrine::VisibleBox>> Boxes;

  vitrine::VisibleBox& VisibleBoxOf(vtkRenderer* renderer)
  {
    for (auto i = this->Boxes.begin(); i != this->Boxes.end();)
    {
      i = i->second.first ? std::next(i) : this->Boxes.erase(i);
    }
    auto& [living, box] = this->Boxes[renderer];
    living = renderer;
    return box;
  }
};

namespace
{

const double DefaultCutOff = 0.5 / 255.0;
const vitrine::EnumNames GridSpaces{ { "view", "world" } };
const vitrine::EnumNames SliceLaws{ { "exponential", "uniform", "NDC uniform" } };

/** Returns the number of clusters of a view, limited since each cell of the world needs a box. */
std::uint32_t CellsLike(vtkRenderer* renderer, const vitrine::ClusterSettings& settings)
{
  constexpr double most = 1 << 20;
  int size[2] = { 1, 1 };
  renderer->GetTiledSize(&size[0], &size[1]);
  const double tiles = std::ceil(static_cast<double>(size[0]) / settings.TileSize) *
    std::ceil(static_cast<double>(size[1]) / settings.TileSize);
  return static_cast<std::uint32_t>(std::clamp(tiles * settings.Slices, 1.0, most));
}
}

//------------------------------------------------------------------------------
vtkClusteredLightsPass::vtkClusteredLightsPass()
  : CutOff(DefaultCutOff)
  , Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkClusteredLightsPass::~vtkClusteredLightsPass()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->GetDelegatePass() << "\n";
  os << indent << "CutOff: " << this->CutOff << "\n";
  os << indent << "GridSpace: " << this->GetGridSpaceAsString() << "\n";
  os << indent << "TileSize: " << this->TileSize << "\n";
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "SliceLaw: " << this->GetSliceLawAsString() << "\n";
  os << indent << "NumberOfLights: " << this->NumberOfLights << "\n";
  os << indent << "NumberOfClusters: " << this->NumberOfClusters << "\n";
  os << indent << "NumberOfUsedClusters: " << this->NumberOfUsedClusters << "\n";
  os << indent << "MeanNumberOfLightsPerCluster: " << this->MeanNumberOfLightsPerCluster << "\n";
  os << indent << "MaximumNumberOfLightsPerCluster: " << this->MaximumNumberOfLightsPerCluster
     << "\n";
  os << indent << "AssignmentTime: " << this->AssignmentTime << "\n";
  os << indent << "Bytes: " << this->Bytes << "\n";
  os << indent << "FallbackReason: " << this->GetFallbackReason() << "\n";
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetDelegatePass(vtkRenderPass* pass)
{
  for (vtkRenderPass* below = pass; below;)
  {
    if (below == this)
    {
      vtkErrorMacro("a pass cannot be its own DelegatePass, nor that of its DelegatePass");
      return;
    }
    auto* const lights = vtkClusteredLightsPass::SafeDownCast(below);
    below = lights ? lights->GetDelegatePass() : nullptr;
  }
  if (this->Private->Delegate != pass)
  {
    this->Private->Delegate = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkClusteredLightsPass::GetDelegatePass()
{
  return this->Private->Delegate;
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetCutOff(double cutOff)
{
  vitrine::SetInRange(this, "CutOff", this->CutOff, cutOff, { 0.0, 1.0 });
}

//------------------------------------------------------------------------------
double vtkClusteredLightsPass::GetDefaultCutOff()
{
  return DefaultCutOff;
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetGridSpace(int space)
{
  vitrine::SetInRange(this, "GridSpace", this->GridSpace, space, GridSpaces);
}

//------------------------------------------------------------------------------
const char* vtkClusteredLightsPass::GetGridSpaceAsString()
{
  return GridSpaces[this->GridSpace];
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetTileSize(int pixels)
{
  vitrine::SetInRange(this, "TileSize", this->TileSize, pixels, { 1, 4096 });
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetNumberOfSlices(int slices)
{
  vitrine::SetInRange(this, "NumberOfSlices", this->NumberOfSlices, slices, { 1, 1024 });
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetSliceLaw(int law)
{
  vitrine::SetInRange(this, "SliceLaw", this->SliceLaw, law, SliceLaws);
}

//------------------------------------------------------------------------------
const char* vtkClusteredLightsPass::GetSliceLawAsString()
{
  return SliceLaws[this->SliceLaw];
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  this->NumberOfRenderedProps = 0;
  this->Bytes = in.Buffers.Bytes();
  this->ForgetFrame();
  in.FallbackReason.clear();
  if (!in.Delegate)
  {
    vtkErrorMacro("no DelegatePass is set, so nothing is drawn");
    return;
  }
  in.FallbackReason = this->FindHindrance(s->GetRenderer());
  auto* const renderer = static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
  if (in.FallbackReason.empty() && this->TakeLights(renderer))
  {
    this->AssignLights(s, renderer);
    if (this->WriteBuffers(renderer))
    {
      this->RenderInLight(s, renderer);
      return;
    }
    this->ForgetFrame();
  }
  in.Delegate->Render(s);
  this->NumberOfRenderedProps = in.Delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// Zeroes the statistics, which are those of frames that are lit by clusters.
void vtkClusteredLightsPass::ForgetFrame()
{
  this->Private->ToldGrid = nullptr;
  this->Private->ToldLists = nullptr;
  this->NumberOfLights = 0;
  this->NumberOfClusters = 0;
  this->NumberOfUsedClusters = 0;
  this->MeanNumberOfLightsPerCluster = 0.0;
  this->MaximumNumberOfLightsPerCluster = 0;
  this->AssignmentTime = 0.0;
}

//------------------------------------------------------------------------------
// Returns why lights cannot be assigned to clusters in this frame. It is empty if they can.
std::string vtkClusteredLightsPass::FindHindrance(vtkRenderer* renderer)
{
  if (!vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    return "the renderer is not one of OpenGL";
  }
  if (renderer->GetRenderWindow()->GetStereoRender())
  {
    // Only the inner passes know which eye is drawn.
    return "the window draws in stereo, whose eyes have views of their own";
  }
  if (vitrine::DrawsShadows(renderer))
  {
    return "VTK's shadow maps need the text that VTK's mappers write for each light";
  }
  return {};
}

//------------------------------------------------------------------------------
const char* vtkClusteredLightsPass::GetFallbackReason()
{
  return this->Private->FallbackReason.c_str();
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::SetFallbackReason(const std::string& reason)
{
  this->Private->FallbackReason = reason;
}

//------------------------------------------------------------------------------
// Returns true if there are lights for this pass to handle.
bool vtkClusteredLightsPass::TakeLights(vtkOpenGLRenderer* renderer)
{
  Internals& in = *this->Private;
  if (vitrine::IsStandIn(vitrine::LightsOf(renderer)))
  {
    return false; // an outer pass of this kind handles the lights
  }
  in.Formula = vitrine::FormulaOf(vitrine::LightsOf(renderer));
  if (in.Formula == vitrine::LightFormula::None || in.Formula == vitrine::LightFormula::Headlight)
  {
    return false;
  }
  this->UpdateLightGeometry(renderer);
  in.Lights.Take(renderer);
  this->NumberOfLights = static_cast<vtkIdType>(in.Lights.Packed.size());
  if (!in.Lights.Left.empty() && in.Reported.insert(in.Lights.Left).second)
  {
    vtkWarningMacro(
      "lights left out, as they would turn black what is lit (not finite, or no attenuation), by "
      "their places in the renderer's collection: "
      << in.Lights.Left);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::AssignLights(const vtkRenderState* s, vtkOpenGLRenderer* renderer)
{
  const auto start = std::chrono::steady_clock::now();
  Internals& in = *this->Private;
  const vitrine::LitProps lit = vitrine::LitPropsOf(s, in.VisibleBoxOf(renderer));
  vitrine::CutLights(in.Lights.Falloffs, lit.Region, vitrine::BudgetOfLight(renderer, this->CutOff),
    in.Lights.Volumes);
  in.Lights.TakeRanges();
  this->MakeGrid(renderer, lit);
  const std::uint32_t used = in.Grid->Assign(in.Assigner, lit, in.Lights.Volumes, in.Lists);
  this->TellOfLists(*in.Grid, in.Lists, used);
  this->AssignmentTime =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::MakeGrid(vtkOpenGLRenderer* renderer, const vitrine::LitProps& lit)
{
  const vitrine::ClusterSettings settings = this->GetClusterSettings();
  if (this->GridSpace == WORLD)
  {
    this->Private->Grid =
      std::make_unique<vitrine::WorldCells>(renderer, lit, CellsLike(renderer, settings));
    return;
  }
  this->Private->Grid = std::make_unique<vitrine::ViewGrid>(renderer, settings);
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::TellOfLists(
  const vitrine::LightGrid& grid, const vitrine::LightLists& lists, std::size_t used)
{
  this->Private->ToldGrid = &grid;
  this->Private->ToldLists = &lists;
  const std::size_t count = lists.Offsets.size() - 1;
  std::size_t most = 0;
  for (std::uint32_t cluster = 0; cluster < count; ++cluster)
  {
    most = std::max(most, lists.CountOf(cluster));
  }
  this->NumberOfClusters = static_cast<vtkIdType>(count);
  this->NumberOfUsedClusters = static_cast<vtkIdType>(used);
  this->MaximumNumberOfLightsPerCluster = static_cast<vtkIdType>(most);
  this->MeanNumberOfLightsPerCluster =
    static_cast<double>(lists.Indices.size()) / static_cast<double>(std::max<std::size_t>(1, used));
}

//------------------------------------------------------------------------------
vitrine::ClusterSettings vtkClusteredLightsPass::GetClusterSettings() const
{
  return { this->TileSize, this->NumberOfSlices, static_cast<vitrine::SliceLaw>(this->SliceLaw) };
}

//------------------------------------------------------------------------------
const vitrine::RendererLights& vtkClusteredLightsPass::GetLights() const
{
  return this->Private->Lights;
}

//------------------------------------------------------------------------------
vtkIdType vtkClusteredLightsPass::GetNumberOfLightsAt(double x, double y, double z)
{
  const Internals& in = *this->Private;
  if (!in.ToldGrid)
  {
    return 0;
  }
  const int cluster = in.ToldGrid->ClusterOf({ x, y, z });
  return static_cast<vtkIdType>(in.ToldLists->CountOf(static_cast<std::uint32_t>(cluster)));
}

//------------------------------------------------------------------------------
bool vtkClusteredLightsPass::WriteBuffers(vtkOpenGLRenderer* renderer)
{
  Internals& in = *this->Private;
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!in.Context.LivesIn(window))
  {
    this->LeaveWindow();
    in.Context.Hold(window);
  }
  const vitrine::KnownLimits::InUse limits(in.Context.Limits());
  this->WarnOfLongLists();
  const std::string problem = in.Buffers.Write(in.Lights.Packed, in.Lists);
  this->Bytes = in.Buffers.Bytes();
  in.FallbackReason = problem;
  if (!problem.empty() && in.Reported.insert(problem).second)
  {
    vtkErrorMacro(<< problem << "; lights are drawn as VTK does");
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
// Llvmpipe ends a shader's loops after 65,535 turns. 32 lights that all reach a pixel take 32 turns to shade and 9 to
// find (LightLoopImpl.glsl), so 50,000 lights fit.
void vtkClusteredLightsPass::WarnOfLongLists()
{
  constexpr vtkIdType most = 50000;
  const std::string warning = "llvmpipe ends the loops of a shader after 65,535 turns, in silence: "
                              "where a cluster has more than 50,000 lights, some may be missing";
  if (this->MaximumNumberOfLightsPerCluster > most && vitrine::IsSoftwareRasteriser() &&
    this->Private->Reported.insert(warning).second)
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::LeaveWindow()
{
  Internals& in = *this->Private;
  in.Context.Release(
    [&](vtkOpenGLRenderWindow*)
    {
      in.Buffers.Release();
      this->ReleaseMethodResources();
    });
  in.Buffers = vitrine::LightBuffers();
  this->ForgetMethodResources();
  in.Context.LetGo();
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::RenderInLight(const vtkRenderState* s, vtkOpenGLRenderer* renderer)
{
  Internals& in = *this->Private;
  const bool isPositional = in.Formula == vitrine::LightFormula::Positional;
  const vitrine::ScopedVolumeLights volumes(in.Delegate, vitrine::LightsOf(renderer));
  const vitrine::ScopedLights oneLight(renderer, isPositional ? in.Positional : in.Directional);
  this->PreRender(s);
  in.Buffers.Bind(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState());
  this->RenderDelegate(s);
  in.Buffers.Unbind();
  this->PostRender(s);
  this->NumberOfRenderedProps = in.Delegate->GetNumberOfRenderedProps();
  vtkOpenGLCheckErrorMacro("failed after Render");
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::RenderDelegate(const vtkRenderState* s)
{
  this->Private->Delegate->Render(s);
}

//------------------------------------------------------------------------------
bool vtkClusteredLightsPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  const std::string problem =
    vitrine::IsLit(fragmentShader) ? vitrine::LoopOverLights(fragmentShader) : std::string();
  if (!problem.empty() && this->Private->Reported.insert(problem).second)
  {
    vtkErrorMacro(<< mapper->GetClassName() << " cannot be lit: " << problem);
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
bool vtkClusteredLightsPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (!program->IsUniformUsed("vitrineLights"))
  {
    return true;
  }
  this->Private->Buffers.SetUniforms(program);
  this->Private->Grid->SetUniforms(program);
  return true;
}

//------------------------------------------------------------------------------
void vtkClusteredLightsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Private;
  if (in.Context.LivesIn(window))
  {
    in.Buffers.Release();
    this->ReleaseMethodResources();
    in.Context.LetGo();
  }
  if (in.Delegate && window)
  {
    in.Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
