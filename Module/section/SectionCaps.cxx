#include "section/SectionCaps.h"

#include "section/SectionCutters.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cstddef>
#include <limits>

namespace vitrine
{

namespace
{

/**
 * How far a cap stands before its plane, as a share of the size of what is cut. Faces of parts that lie in the plane
 * are behind it then, in depth buffers of 24 bits too.
 */
constexpr double CapLift = 1.0 / (1 << 17);

/** The width of a hatch's lines, of their distance. */
constexpr float HatchLine = 0.12f;
}

int CapStyle::HatchOf(vtkProp* prop, int block) const
{
  for (const int wanted : { block, EveryBlock })
  {
    const auto found = this->Hatches.find({ prop, wanted });
    if (found != this->Hatches.end() && found->second.first)
    {
      return found->second.second;
    }
  }
  return this->Hatch;
}

void SectionCaps::Update(
  vtkRenderer* renderer, const CutParts& parts, const SectionPlanes& planes, const WorldBox& scene)
{
  this->Parts = &parts;
  this->Planes = &planes;
  this->Make(renderer);
  this->Place(scene);
}

void SectionCaps::Make(vtkRenderer* renderer)
{
  const std::size_t wanted = 2 * this->Planes->Planes.size();
  while (this->Actors.size() > wanted)
  {
    renderer->RemoveViewProp(this->Actors.back());
    this->Actors.pop_back();
  }
  while (this->Actors.size() < wanted)
  {
    const auto cap = vtkSmartPointer<CapActor>::New();
    cap->Plane = static_cast<int>(this->Actors.size() / 2);
    cap->SetForTranslucent(this->Actors.size() % 2 != 0);
    const bool isForTranslucent = cap->IsForTranslucent;
    cap->Begin = [this, isForTranslucent](vtkRenderer* drawn)
    { return this->Begin(drawn, isForTranslucent); };
    cap->End = [this] { this->Sums.Unbind(); };
    cap->Release = [this](vtkWindow* window)
    {
      this->OnRelease(window);
      this->Sums.Release(window);
    };
    this->Actors.push_back(cap);
  }
  for (const auto& cap : this->Actors)
  {
    // Applications may have removed all props.
    if (!renderer->GetViewProps()->IsItemPresent(cap))
    {
      renderer->AddViewProp(cap);
    }
  }
}

void SectionCaps::Place(const WorldBox& scene)
{
  this->Min = scene.Min;
  this->Max = scene.Max;
  std::array<std::uint32_t, 2> cuts{ 0, 0 }; // planes that cut opaque parts, and translucent ones
  for (const CutPart& part : this->Parts->Parts())
  {
    if (part.Slot == 0)
    {
      continue;
    }
    this->Min = glm::min(this->Min, part.Min);
    this->Max = glm::max(this->Max, part.Max);
    cuts[part.Look.Diffuse.a < 1.0f ? 1 : 0] |= part.Cuts;
  }
  cuts[0] |= cuts[1]; // where translucent parts interfere, the cap is opaque
  const double lift = CapLift * glm::length(this->Max - this->Min);
  for (const auto& cap : this->Actors)
  {
    const auto plane = static_cast<std::size_t>(cap->Plane);
    const bool isThere =
      this->Style.Caps && (cuts[cap->IsForTranslucent ? 1 : 0] >> plane & 1u) != 0;
    cap->SetVisibility(isThere);
    if (isThere)
    {
      cap->Place(this->Planes->Planes[plane].MovedBy(lift), this->Min, this->Max);
    }
  }
}

bool SectionCaps::Begin(vtkRenderer* renderer, bool isForTranslucent)
{
  // Methods draw translucent caps into targets of their own, whose samples may have another meaning.
  this->Samples = isForTranslucent ? this->Samples : CutSums::SamplesOfTarget();
  this->SetSamples(this->Samples);
  this->Reason = this->Prepare(renderer);
  if (!this->Reason.empty() && this->Reason != this->ToldReason)
  {
    this->ToldReason = this->Reason;
    this->Warn(this->Reason);
  }
  return this->Reason.empty();
}

/** Draws the sums, and binds them with the tables. Returns a reason if it cannot. */
std::string SectionCaps::Prepare(vtkRenderer* renderer)
{
  std::string reason = this->Sums.Draw(renderer, *this->Parts, *this->Planes, this->Samples);
  if (reason.empty())
  {
    reason = this->Sums.WriteTables(
      renderer, *this->Parts,
      [this](const CutPart& part)
      { return this->Style.HatchOf(part.Prop, static_cast<int>(part.Block)); },
      this->Planes->OfAllParts);
  }
  if (reason.empty())
  {
    this->Drawn.Keep(*this->Parts, this->Planes->Planes);
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    reason = this->Sums.Bind(window->GetState());
    const int* const whole = window->GetSize();
    const double* const tile = window->GetTileViewport();
    this->FirstOfTile = static_cast<float>(std::round(tile[0] * whole[0] + tile[1] * whole[1]));
  }
  return reason;
}

void SectionCaps::SetUniforms(vtkShaderProgram* program, vtkProp* prop) const
{
  auto* const cap = static_cast<CapActor*>(prop);
  this->Sums.SetUniforms(program, cap->Plane, cap->IsForTranslucent);
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glUniform4i(glGetUniformLocation(handle, "vitrineCapStyle"), this->Style.EdgeWidth,
    this->Sums.FirstOpenLayer(), this->Sums.LayerOf(static_cast<std::size_t>(cap->Plane)),
    this->Style.InterferenceStripes ? 1 : 0);
  const float color[4] = { static_cast<float>(this->Style.EdgeColor[0]),
    static_cast<float>(this->Style.EdgeColor[1]), static_cast<float>(this->Style.EdgeColor[2]),
    1.0f };
  program->SetUniform4f("vitrineCapEdge", color);
  const double spacing = this->Style.HatchSpacing > 0.0 ? this->Style.HatchSpacing
                                                        : glm::length(this->Max - this->Min) / 40.0;
  const float spacings[3] = { static_cast<float>(spacing), HatchLine, this->FirstOfTile };
  program->SetUniform3f("vitrineCapSpacing", spacings);
}

Interference SectionCaps::FindInterference()
{
  return this->Parts ? vitrine::FindInterference(this->Sums, *this->Parts, this->Drawn)
                     : Interference();
}

void SectionCaps::Remove(vtkRenderer* renderer)
{
  for (const auto& cap : this->Actors)
  {
    if (renderer)
    {
      renderer->RemoveViewProp(cap);
    }
    cap->Begin = nullptr;
    cap->Release = nullptr;
  }
  this->Actors.clear();
}

}
