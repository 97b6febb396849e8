/**
 * The transparency methods by the names that commands, JSON and charts use.
 */
#ifndef VITRINE_METHOD_H
#define VITRINE_METHOD_H

#include "scene/Lights.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkRenderer;

namespace program
{

/** Names of a frame's stages, and what they take on the device in milliseconds. */
using StageTimes = std::vector<std::pair<std::string, double>>;

/** What a method tells about the last frame; what it cannot tell is left out. */
struct MethodStatistics
{
  std::optional<std::int64_t> Fragments;
  std::optional<std::int64_t> Lost; ///< fragments that the method could not keep
  bool LostIsLeast = false;         ///< there were more than could be counted
  std::optional<std::int64_t> LayersMax;
  std::optional<double> LayersMean;
  std::optional<std::int64_t> GeometryPasses;
  std::optional<std::int64_t> Bytes;
  std::optional<std::string> Chosen;     ///< the method that one with an error budget chose
  std::optional<double> GuaranteedError; ///< the largest error that the frame can have
  std::string BudgetProblem; ///< why that is more than the error budget; empty if it is not
  StageTimes Stages;         ///< empty unless they are measured
};

/** The tolerance within which fragments coincide; see vtkTolerantTransparencyPass::SetCoincidenceSteps(). */
struct Coincidence
{
  double Steps = 0.0; ///< of 2^-24 of the window's depth
  double Slope = 0.0; ///< times the slope of the depth, a pixel

  bool IsOn() const { return this->Steps > 0.0 || this->Slope > 0.0; }
};

/** One method, attached to one renderer. */
class Method
{
public:
  virtual ~Method() = default;

  /** Have the renderer draw translucent geometry by this method. */
  virtual void Attach(vtkRenderer* renderer) = 0;

  /**
   * Set the coincidence tolerance. Returns why the method cannot have one, or an empty string. A method without it does
   * not draw what was asked for, and truth with the tolerance does not judge it.
   */
  [[nodiscard]] virtual std::string SetCoincidence(const Coincidence& coincidence);

  /** Set the error budget, a channel's in [0, 1]. Returns why the method cannot have one, or an empty string. */
  [[nodiscard]] virtual std::string SetErrorBudget(double budget);

  /** How many lights of a scene it draws. */
  virtual std::size_t MostLights() const { return MostLightsOfVTK; }

  /** Measure the stages of frames on the device. Called before Attach(). */
  virtual void MeasureStages() {}

  /** Of the last frame. */
  virtual MethodStatistics Statistics() const = 0;

  /** Why the last frame was not drawn by this method; empty if it was. */
  virtual std::string WhyNotRun() const { return ""; }
};

/** The method that has an error budget, and the budget that it has by default. */
inline constexpr const char* AutomaticName = "automatic";
inline constexpr double DefaultErrorBudget = 1.0 / 255.0;

/** Notes on stderr that a frame may exceed its error budget, if it may. */
void PrintBudgetProblem(const MethodStatistics& statistics);

/** What the method automatic keeps. */
struct AutomaticLimits
{
  double ErrorBudget = DefaultErrorBudget;
  double FrameTime = 0.0; ///< in milliseconds, 0 for none; see vtkSeeThroughPass::SetFrameTime()
};

/** Make the method of that name. Throws InputError that lists the known ones. */
std::unique_ptr<Method> MakeMethod(const std::string& name);

/** Names in a comma-separated list in which groups (exact, all) stand for their members. */
std::vector<std::string> ParseMethodList(const std::string& list);

/** One line for each method, for --help. */
std::string DescribeMethods();

}
#endif
