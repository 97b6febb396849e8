/**
 * The methods that tests run through, and how they are judged.
 */
#ifndef VITRINE_TEST_METHODS_H
#define VITRINE_TEST_METHODS_H

#include "TestScene.h"
#include "vtkTransparencyPass.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

class vtkABufferTransparencyPass;
class vtkImageData;
class vtkSeeThroughPass;

/** A transparency method in one of its settings. */
struct Method
{
  std::string Name; // letters only
  std::function<vtkSmartPointer<vtkTransparencyPass>()> Make;

  /** The largest distance from the truth, in steps of 1/255, that storage and rounding explain in small scenes. */
  double Tolerance;

  /** The most layers of a pixel that it keeps; 0 for any number. */
  int MaxLayers = 0;

  /** The share of a small scene's pixels that may be wrong, since they lie at the edges of polygons. */
  double EdgeShare = 0.0;

  /** Why it refuses multisampled targets, in part of a sentence; empty if it takes them. */
  std::string RefusesSamples = "";

  /** What of OpenGL it asks for. */
  std::string NeedsOpenGL = "4.3";

  /** The samples of targets to draw into: none and, where it takes them, 4. */
  std::vector<int> Samples() const
  {
    return this->RefusesSamples.empty() ? std::vector<int>{ 0, 4 } : std::vector<int>{ 0 };
  }

  /** Whether it keeps so many layers. */
  bool Keeps(int layers) const { return this->MaxLayers == 0 || layers <= this->MaxLayers; }

  /** Whether it draws into groups of pixels, whose edges are inexact. */
  bool HasGroups() const { return this->EdgeShare > 0.0; }

  /** Whether colours are kept in 8 bits, for which its tolerance leaves room. */
  bool KeepsEightBits() const { return this->Tolerance > 1.2; }

  /** Bytes that an A-buffer pass takes of each fragment: more where it keeps half floats, which are the most exact. */
  int NodeBytes() const { return this->Tolerance < 1.0 ? 12 : 8; }
};

std::ostream& operator<<(std::ostream& os, const Method& method);

/** Methods whose only error is rounding: each setting of theirs in one of them, not all settings together. */
const std::vector<Method>& ExactMethods();

/** Methods that keep the first layers of each pixel, and are inexact at the edges of polygons. */
const std::vector<Method>& MaskMethods();

/** Methods that route fragments by the stencil: exact up to its reach, with one sample a pixel. */
const std::vector<Method>& RoutedMethods();

/** ExactMethods(), RoutedMethods(), MaskMethods() and truth. */
const std::vector<Method>& AllMethods();

/** Those of AllMethods() of which `is` holds. */
std::vector<Method> MethodsThat(bool (*is)(const Method& method));

/** Those of AllMethods() that store every fragment, within a memory limit: of the class vtkABufferTransparencyPass. */
const std::vector<Method>& ABufferMethods();

/** A new pass of one of ABufferMethods(). */
vtkSmartPointer<vtkABufferTransparencyPass> MakeABuffer(const Method& method);

/** A pass for a whole frame, with a new one of the method. */
vtkSmartPointer<vtkSeeThroughPass> MakeSeeThrough(const Method& method);

/** Those of AllMethods() that take multisampled targets, and those that refuse them. */
const std::vector<Method>& MultisamplingMethods();
const std::vector<Method>& SingleSampleMethods();

/** For INSTANTIATE_TEST_SUITE_P over methods. */
struct MethodName
{
  template <class Info>
  std::string operator()(const Info& info) const
  {
    return info.param.Name;
  }
};

/** The same over an A-buffer pass's ways to keep colours. */
struct StorageName
{
  template <class Info>
  std::string operator()(const Info& info) const
  {
    const char* const names[] = { "HalfFloat", "EightBit", "Compact" };
    return names[info.param];
  }
};

/**
 * The largest distance of any channel from truth's float picture in steps of 1/255; infinite if a size differs. The
 * `besides` share of the channels, those that are farthest off, is left out.
 */
double DistanceFromTruth(const Picture& picture, vtkImageData* truth, double besides = 0.0);

/**
 * Draw the scene by truth and by `pass`, and expect the same statistics and, within `tolerance` steps of
 * 1/255, the same picture. The scene must have translucent fragments. Where the `besides` share of the pixels may be
 * wrong, the statistics may be so by a twentieth. Returns the picture by `pass`.
 */
Picture ExpectTruth(
  TestScene& scene, vtkTransparencyPass* pass, double tolerance, double besides = 0.0);

/**
 * Call ExpectTruth() with a new pass of every method of ExactMethods() and RoutedMethods(), each within its tolerance
 * times `slack`.
 */
void ExpectAllAreTruth(TestScene& scene, double slack = 1.0);

/** Expect that the last frame was VTK's, since the pass refused it with a reason that contains `text`, said once. */
void ExpectRefusal(vtkTransparencyPass* pass, const std::string& text);

#endif
