/**
 * A scene's views, and truth of each: drawn once, for all methods.
 */
#ifndef VITRINE_SCENE_TRUTH_H
#define VITRINE_SCENE_TRUTH_H

#include "methods/Stage.h"
#include "scene/Scene.h"
#include "stability/Stability.h"

#include <string>
#include <vector>

namespace program
{

/** Truth's picture of a window of another size or with samples. */
struct OtherTruth
{
  std::string Name;
  PictureSize Size;
  int Multisamples;
  vitrine::Image Picture;
  std::string Skipped; ///< why truth cannot run there; no picture then
};

struct SceneTruth
{
  StabilityScene Entry;
  Scene Parts;
  PictureSize Size;
  int Repetitions;
  std::vector<std::vector<std::size_t>> Orders;   ///< of parts
  std::vector<vtkSmartPointer<vtkCamera>> Shifts; ///< the first is the scene's own view
  std::size_t ShiftRun =
    0; ///< so many of them follow each other by a step; the next begin elsewhere
  std::vector<vtkSmartPointer<vtkCamera>> Turns; ///< likewise
  std::size_t TurnRun = 0;
  std::string Skipped; ///< why there is no truth; no pictures then
  std::vector<vitrine::Image> ShiftPictures;
  std::vector<vitrine::Image> TurnPictures;
  std::vector<OtherTruth> Others;
};

/** A camera for a window of that size, in the scene's own view. */
vtkSmartPointer<vtkCamera> OwnView(const Scene& scene, PictureSize size);

/** Draw as the entry says: after a frame of another zoom, if it has one. */
void DrawAfterZoom(Stage& stage, vtkCamera* camera, const StabilityScene& entry);

/** Plan the views of a scene, and draw truth of them in the windows given, of one sample and of several. */
SceneTruth DrawTruth(const StabilityScene& entry, const StabilitySettings& settings,
  TruthStage& single, TruthStage& multisampled);

}
#endif
