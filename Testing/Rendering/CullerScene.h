/**
 * Scenes drawn with and without vtkHierarchicalSBufferCuller, whose pictures have to be the same to the last bit.
 */
#ifndef VITRINE_CULLER_SCENE_H
#define VITRINE_CULLER_SCENE_H

#include "RecordingCuller.h"
#include "TestScene.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkMapper;
class vtkPolyData;

/** How a scene is drawn and culled. */
struct CullerSetting
{
  std::string Name;
  int Samples;
  bool IsParallel;
  int BufferLines;
  int Width;
  int Height;
};

/** Each projection with one sample and with four; with lines of a pixel each and with thick ones. */
std::vector<CullerSetting> CullerSettings();
std::vector<CullerSetting> CullerSettingsOfOneSample();

using Point3 = std::array<double, 3>;
using Triangle = std::array<Point3, 3>;
using Quad = std::array<Point3, 4>;

/** A mesh of triangles or quads, none of which shares a point with another. */
vtkSmartPointer<vtkPolyData> MeshOfTriangles(const std::vector<Triangle>& triangles);
vtkSmartPointer<vtkPolyData> MeshOf(const std::vector<Quad>& quads);

/** A rectangle in the plane of height z, facing +z. */
Quad Rectangle(double x0, double y0, double x1, double y1, double z);

/** A wall at height 0 that is wider than the view, with coordinates of a texture. */
vtkSmartPointer<vtkPolyData> TexturedWall();

/** Of 2 x 2 pixels of bytes, all of which are the same value. */
vtkSmartPointer<vtkImageData> PlainImage(int components, double value);

/** Moves points in place, of which nobody is told. */
void MovePointsInPlace(vtkPolyData* mesh, const Point3& by);

/** The wall from -1.5 to 1.5 at height 0 that is left of slits so wide, each at a slant of its own. */
std::vector<Quad> StripsBetweenSlits(double width, std::uint64_t seed);

/** What lies behind z = 0 is hidden where something stands there; the camera looks along -z from any side of it. */
struct CullerScene : TestScene
{
  explicit CullerScene(const CullerSetting& setting);

  /** Boxes in one layer behind z = 0, all of them in view from each pose, none of which hides another one wholly. */
  std::vector<vtkSmartPointer<vtkActor>> AddHidden(double z = -0.4);

  /** An opaque wall at height 0, in front of all of those boxes, and wider than the view. */
  vtkSmartPointer<vtkActor> AddWall(double z = 0.0);

  /** An unlit box of a colour of its own; MakeBox() leaves it out of the renderer. */
  vtkSmartPointer<vtkActor> AddBox(const Point3& middle, const Point3& size);
  vtkSmartPointer<vtkActor> MakeBox(const Point3& middle, const Point3& size);

  vtkSmartPointer<vtkActor> AddMesh(vtkPolyData* mesh, const Rgba& color = { 0.5, 0.5, 0.5, 1.0 });

  /** An unlit line of one cell. */
  vtkSmartPointer<vtkActor> AddLine(
    const Point3& from, const Point3& to, const Rgba& color = { 0.5, 0.5, 0.5, 1.0 });

  /** Take all props out. */
  void Clear();

  /** Look from straight ahead. */
  void LookAhead();

  /**
   * Look so that a sample is in the middle of the screen even with several samples per pixel. With 4, the samples lie
   * an eighth of a pixel beside the pixel's centre.
   */
  void PutSampleInMiddle();

  /** Look from anywhere in front. */
  void LookFromAnywhere(TestRandom& random);

  /** Draw a frame. What was left out of frames before is forgotten, if something may be left out of this one. */
  Picture Render();

  /** Whether any of some parts shows from where the camera is, if nothing is culled; culling stays off. */
  bool ShowsUnculled(const std::vector<vtkSmartPointer<vtkActor>>& parts);

  /** Expect the same picture of a culled frame, the last one with culling, as without culling. */
  void ExpectSamePictures(const Picture& culled, const Picture& plain);

  /**
   * Draw with and without culling, and expect the same picture; culling stays off. Returns how many parts were left
   * out, which a test must look at: a culler that leaves out nothing draws the same picture, too.
   */
  [[nodiscard]] int ExpectSame();

  /** The same from straight ahead and from several poses. Returns the most parts that were left out in one. */
  [[nodiscard]] int ExpectSameAround(std::uint64_t seed, int poses = 2);

  /** The same, and that parts are left out in at least one pose. */
  void ExpectHidden(std::uint64_t seed, int poses = 2);

  /** The same, and that nothing is left out in any pose. */
  void ExpectNothingHidden(std::uint64_t seed, int poses = 2);

  /** The size of a pixel at height 0, seen from straight ahead. */
  double PixelSize() const;

  CullerSetting Setting;
  vtkNew<RecordingCuller> Culler;

private:
  std::array<double, 3> NextColor();

  vtkSmartPointer<vtkMapper> BoxMapper; ///< of all boxes
  TestRandom Colors{ 7 };
};

/** A scene for each of CullerSettings(). */
class CullerTest : public testing::TestWithParam<CullerSetting>
{
protected:
  CullerScene Scene{ GetParam() };
};

inline std::string CullerSettingName(const testing::TestParamInfo<CullerSetting>& info)
{
  return info.param.Name;
}

void PrintTo(const CullerSetting& setting, std::ostream* os);

#endif
