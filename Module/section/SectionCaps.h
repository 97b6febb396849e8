/** The caps of a section in the renderer that it cuts. */
#ifndef VITRINE_SECTION_SECTION_CAPS_H
#define VITRINE_SECTION_SECTION_CAPS_H

#include "section/CapActor.h"
#include "section/CutParts.h"
#include "section/CutSums.h"
#include "section/Interference.h"
#include "section/PropBoxes.h"
#include "section/SectionPlanes.h"

#include "vtkProp.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

namespace vitrine
{

/** How caps look. */
struct CapStyle
{
  bool Caps = true;
  bool InterferenceStripes = true;
  int Hatch = 0; ///< vtkSection::HatchType
  /** Hatches of props, with a block or EveryBlock, in place of the general one. */
  std::map<std::pair<vtkProp*, int>, std::pair<vtkWeakPointer<vtkProp>, int>> Hatches;
  double HatchSpacing = 0.0; ///< in WC; 0 stands for a share of what is cut
  int EdgeWidth = 1;
  std::array<double, 3> EdgeColor{ 0.0, 0.0, 0.0 };

  int HatchOf(vtkProp* prop, int block) const;
};

class SectionCaps
{
public:
  CapStyle Style;

  /** Called before a cap is drawn, with the samples of a pixel of the sums, 0 for one. */
  std::function<void(int)> SetSamples;
  /** Called with a window whose resources are released. */
  std::function<void(vtkWindow*)> OnRelease;
  /** Called with a new reason why caps are not drawn. */
  std::function<void(const std::string&)> Warn;

  /**
   * Give each plane its two caps, in the renderer's props, and place them. The parts and planes are those of a frame,
   * and live as long as the caps. Caps reach through a box of the scene, too, which may be empty.
   */
  void Update(vtkRenderer* renderer, const CutParts& parts, const SectionPlanes& planes,
    const WorldBox& scene);

  /** Take all caps from a renderer, which may be null. */
  void Remove(vtkRenderer* renderer);

  /** Set the uniforms of a cap's lookups. */
  void SetUniforms(vtkShaderProgram* program, vtkProp* cap) const;

  /** Returns which parts interfere in the sums of the last frame. */
  Interference FindInterference();
  const DrawnSums& LastDrawn() const { return this->Drawn; }
  const std::string& FallbackReason() const { return this->Reason; }
  std::int64_t Bytes() const { return this->Sums.Bytes(); }
  void Release() { this->Sums.Release(); }

private:
  void Make(vtkRenderer* renderer);
  void Place(const WorldBox& scene);
  bool Begin(vtkRenderer* renderer, bool isForTranslucent);
  std::string Prepare(vtkRenderer* renderer);

  std::vector<vtkSmartPointer<CapActor>> Actors;
  CutSums Sums;
  const CutParts* Parts = nullptr;
  const SectionPlanes* Planes = nullptr;
  DrawnSums Drawn;
  glm::dvec3 Min{ 0.0 }; ///< the box around the parts that are cut, and the scene, in WC
  glm::dvec3 Max{ 0.0 };
  float FirstOfTile =
    0.0f;          ///< x + y of the window's first pixel in a picture that is drawn in tiles
  int Samples = 0; ///< of a pixel of the frame, 0 for one
  std::string Reason;
  std::string ToldReason; ///< of the last warning
};

}

#endif
