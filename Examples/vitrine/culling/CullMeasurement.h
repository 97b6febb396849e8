/**
 * Frames with and without vtkHierarchicalSBufferCuller, side by side.
 */
#ifndef VITRINE_PROGRAM_CULL_MEASUREMENT_H
#define VITRINE_PROGRAM_CULL_MEASUREMENT_H

#include "culling/CullPoses.h"
#include "culling/SceneForm.h"
#include "methods/Device.h"
#include "methods/Stage.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace program
{

struct CullSettings
{
  PictureSize Size = { 480, 270 };
  int Multisamples = 0;
  int Poses = 20;
  int SkippedPoses = 0; ///< of the row, before the first one
  PoseProjection Projection = PoseProjection::Both;
  std::uint64_t Seed = 1;
  std::string Method = "vtk-oit";
  int BufferLines = 0;              ///< at most; 0 for as many as pay
  double TurnDegrees = 0.0;         ///< of the camera around its focal point since the frame before
  std::optional<double> OpaqueFrom; ///< parts of no less opacity were made opaque, if any were
  bool CountsIdeal = true;          ///< where parts are those of the scene
  SceneForm Form = SceneForm::Actors;
  bool ShowsBuffer = false; ///< in a picture of the last pose
};

/** How many props each reason of vtkHierarchicalSBufferCuller::GetReason(prop) is told of. */
using PropReasons = std::map<std::string, std::size_t>;

/** One pose. */
struct CullFrame
{
  std::string Mode;      ///< of the culler: "occlusion", "view only", ...
  std::string Reason;    ///< why it is no better; empty if it is "occlusion"
  PropReasons Props;     ///< of all props
  int Lines = 0;         ///< of the s-buffer
  std::size_t Drawn = 0; ///< parts that the culler left
  std::size_t Ideal = 0; ///< opaque parts that own a pixel
  double CullMilliseconds = 0.0;
  double FrameMilliseconds = 0.0;
  double FrameMillisecondsWithout = 0.0;
  double FrameMillisecondsIdeal = 0.0; ///< by a culler that leaves the ideal parts, at no cost
  std::int64_t WrongPixels = 0;        ///< that differ between the two
};

struct CullRun
{
  std::string Name;
  std::size_t Parts = 0; ///< of a mesh, what it is cut into
  std::size_t OpaqueParts = 0;
  int Samples = 1;             ///< of a pixel: what the device has of those that were asked for
  bool HasIdealFrames = false; ///< only actors can be left out by a culler
  CullSettings Settings;
  Device DrawnBy;
  std::vector<CullFrame> Frames;
  std::vector<std::uint8_t>
    LastPicture; ///< the last pose with its s-buffer, see WithBuffer(), if it is asked for
};

/** @param progress  is called before each pose with what was measured before it */
CullRun MeasureCulling(const Scene& scene, const CullSettings& settings,
  const std::function<void(const CullRun&)>& progress);

}

#endif
