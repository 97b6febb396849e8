/** What a reveal does: it captures what is in front of parts, finds opacities, fades and cuts. */
#ifndef VITRINE_INSPECTION_REVEAL_WORK_H
#define VITRINE_INSPECTION_REVEAL_WORK_H

#include "Core/geometry/PixelRegion.h"
#include "Core/reveal/FrontStacks.h"
#include "Core/reveal/SteadyReveal.h"
#include "inspection/Cutaway.h"
#include "inspection/LayerCapture.h"
#include "inspection/PartOnScreen.h"
#include "inspection/PixelRays.h"
#include "inspection/RevealedParts.h"
#include "scene/FadedLooks.h"
#include "scene/PartNumbers.h"
#include "vtkPartOutlines.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

struct RevealWork
{
  vtkWeakPointer<vtkRenderer> Renderer;
  RevealedParts Parts;
  vtkNew<LayerCapture> Capture;
  Cutaway Hole;
  vtkSmartPointer<vtkPartOutlines> Outlines;
  FadedLooks Looks;
  std::string Problem;
  std::string ToldProblem;                       ///< that of the last frame
  std::array<unsigned long, 2> FrameObservers{}; ///< where the camera is followed
  unsigned long EndObserver = 0;
  vtkMTimeType CameraTime = 0; ///< of the camera when it was last followed
  vtkMTimeType SceneTime = 0;  ///< of what the renderer shows after the last update
  PixelRegion Viewport;        ///< of the last update
  bool IsUpdating = false;
  bool IsWanted = false; ///< an update was asked for, and not put back since

  std::optional<SteadyReveal>
    Steady; ///< absent before the first update, and if a setting has changed
  double Share = 0.0;
  double ChangePerDegree = 0.0;
  glm::dvec3 Towards{ 0.0 }; ///< the direction from the parts to the eye in the last update

  // What the last update found.
  SteadyReveal::Change Change;
  std::size_t Pixels = 0;
  std::size_t Front = 0;
  std::size_t Stacks = 0;
  std::size_t Layers = 0;
  double Context = 0.0;
  struct FadedPart
  {
    ShownPart Part;
    std::uint32_t Number;
    double Opacity;
    double Original;
  };
  std::vector<FadedPart> Faded;
  std::map<std::uint32_t, ShownPart> Cut; ///< parts that have a hole, by numbers

  const FadedPart* At(int i) const;

  /** What is in front of the parts in a view. */
  struct View
  {
    PixelRays Rays;
    std::vector<BoxCorners> Boxes; ///< of the parts that shall show
    PixelRegion Region;
    FrontStacks Stacks;
    bool IsAtOnce = false; ///< opacities may change by any amount

    /** Returns the middle of the parts that shall show, in WC. */
    glm::dvec3 Middle() const;
  };

  /** Returns why the reveal cannot be found, or an empty string. */
  std::string FindProblem(bool cuts) const;

  /** Captures what is in front, as if nothing were hidden or cut. Returns why it cannot, or an empty string. */
  std::string CaptureView(View& view, bool withNear);

  /** Returns what each part in front counts for, and the opacity that it has without being faded. */
  std::vector<SteadyReveal::FrontPart> FrontPartsOf(const View& view, bool byArea);

  /**
   * Takes the parts out of the stacks that would have less than a share of their opacity, and chooses them for the
   * hole. Parts that had a hole keep it while they are in front.
   */
  void ChooseCut(View& view, double least, bool byArea);

  /** Cuts the hole for the parts that were chosen. */
  void CutHole(const View& view);

  SteadyReveal NewSteady() const;

  /** Starts anew if a setting has changed. Returns true if it did. */
  bool TakeSettings(double share, double changePerDegree);

  /** Returns the mean opacity of parts in front by their weights. Those with less than `least` count as hidden. */
  double ContextOf(const FrontStacks& stacks, const std::vector<SteadyReveal::FrontPart>& parts,
    double least) const;

  /** Notes what the frame shows, so that later changes are seen. */
  void NoteFrame();

  /** Returns true if what the renderer shows, or its viewport, has changed since the last update. */
  bool HasSceneChanged() const;

  /** Returns by how many degrees the eye has turned around a place since the last update, and notes where it is. */
  double Turned(const glm::dvec3& middle);

  /** Sets the opacities that were found. Parts with less than `least` are hidden. */
  void SetLooks(double least);

  /** Gives the faded parts their outlines, which spare the parts that shall show. */
  void DrawOutlines();

  /** Puts all looks back, and forgets what was found. */
  void Forget();
};

}

#endif
