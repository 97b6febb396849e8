/**
 * The ways in which a scene's lights are drawn, by the names that the command line and JSON use.
 */
#ifndef VITRINE_LIGHTING_MODE_H
#define VITRINE_LIGHTING_MODE_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace program
{

/** What modes that cut the view into clusters are told; the others take no notice. */
struct LightingSettings
{
  int TileSize = 64;                    ///< in pixels
  int Slices = 16;                      ///< of depth, at most
  std::string SliceLaw = "exponential"; ///< or "uniform", "ndc"
  double CutOff = 0.5 / 255.0; ///< what lights may lack of the picture, all together; 0 for nothing
};

/** What a mode tells about the last frame; what it cannot tell is left out. */
struct LightingStatistics
{
  std::optional<double> AssignmentMilliseconds; ///< of lights to clusters
  std::optional<double> LightsPerClusterMean;   ///< of clusters that are used
  std::optional<std::int64_t> LightsPerClusterMax;
  std::optional<std::int64_t> Clusters;
  std::optional<std::int64_t> ClustersUsed; ///< that hold something to be lit
  std::optional<std::int64_t> Bytes;        ///< of device memory, for lights, clusters and targets
};

/** One mode, attached to one renderer. */
class LightingMode
{
public:
  virtual ~LightingMode() = default;

  /** Why so many lights are too many; empty if they are not. Asked before anything is drawn. */
  virtual std::string WhyTooMany(std::size_t lights) const = 0;

  /** Have the renderer draw its lights by this mode; it has a pass that draws a frame. */
  virtual void Attach(vtkRenderer* renderer) = 0;

  /** Of the last frame. */
  virtual LightingStatistics Statistics() const = 0;

  /** How many lights the last frame looked at for each pixel, rows from the bottom. */
  virtual std::vector<std::uint32_t> LightsOfPixels(std::size_t pixels) const = 0;

  /** Why the last frame was not drawn by this mode; empty if it was. */
  virtual std::string WhyNotRun() const { return ""; }
};

/** Make the mode of that name, which ParseModeList() has let pass. */
std::unique_ptr<LightingMode> MakeLightingMode(
  const std::string& name, const LightingSettings& settings);

/** The mode whose picture is right with so many lights; empty if there is none. */
std::string ReferenceMode(std::size_t lights);

/** Names in a comma-separated list, each once. Throws InputError that lists the known ones. */
std::vector<std::string> ParseModeList(const std::string& list);

/** One line for each mode, for --help. */
std::string DescribeModes();

}
#endif
