// Tests faces that a device cuts at the view's planes. If little is cut off, slivers may remain. llvmpipe draws some of
// them nearer than a wall that stands before the whole face. Culling must lose no pixel of them.
#include "CullerScene.h"

#include "vtkCamera.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <ostream>
#include <vector>

namespace
{

const int Columns = 160;
const int Lines = 90;
const double Middle = 1000.0; // of the view, as far from its near plane as from its far one
const double Slope = 25.0;    // of depth, by column

// A face with a corner that is cut off, in columns from where it is cut and in lines.
struct CutFace
{
  double Beyond, Line;
  double Inside[2][2];
};

// One plane of depth has all faces that are cut by a plane.
struct CutPlane
{
  const char* Name;
  double Column; // where it cuts them
  double Depth;  // there, along z
  double ByColumn;
  double ByLine;
  double WallFrom; // columns, as faces have them
  std::vector<CutFace> Faces;
};

void PrintTo(const CutPlane& plane, std::ostream* os)
{
  *os << plane.Name;
}

// A unit to a pixel, with the lower left corner of the view in the origin.
class CullerCuts : public testing::TestWithParam<CutPlane>
{
protected:
  void LookAhead()
  {
    vtkCamera* camera = Scene.Renderer->GetActiveCamera();
    camera->SetParallelScale(0.5 * Lines);
    camera->SetFocalPoint(0.5 * Columns, 0.5 * Lines, 0.0);
    camera->SetPosition(0.5 * Columns, 0.5 * Lines, Middle);
    camera->SetClippingRange(1.0, 2.0 * Middle + 1.0);
  }

  Point3 At(double inside, double line, double nearer = 0.0) const
  {
    const CutPlane& plane = GetParam();
    return { plane.Column + inside, line,
      plane.Depth + plane.ByColumn * inside + plane.ByLine * (line - 0.5 * Lines) + nearer };
  }

  void AddFace(const CutFace& face)
  {
    const auto& inside = face.Inside;
    Scene.AddMesh(MeshOfTriangles({ { this->At(-face.Beyond, face.Line),
                    this->At(inside[0][0], inside[0][1]), this->At(inside[1][0], inside[1][1]) } }),
      { 1.0, 0.0, 0.0, 1.0 });
  }

  void AddWall(double nearer)
  {
    const double left = GetParam().WallFrom, right = 62.0, bottom = -3.0, top = Lines + 3.0;
    Scene.AddMesh(MeshOf({ { this->At(left, bottom, nearer), this->At(right, bottom, nearer),
      this->At(right, top, nearer), this->At(left, top, nearer) } }));
  }

  // What is surely behind the wall, where that is not cut.
  void AddHidden()
  {
    for (int i = 0; i < 20; ++i)
    {
      const double left = 20.0 + i, low = 30.0 + i;
      Scene.AddMesh(MeshOf({ { this->At(left, low, -100.0), this->At(left + 1.0, low, -100.0),
        this->At(left + 1.0, low + 1.0, -100.0), this->At(left, low + 1.0, -100.0) } }));
    }
  }

  CullerScene Scene{ { "", 0, true, 270, Columns, Lines } };
};

// What is known of depths is less than what they differ by.
TEST_P(CullerCuts, AlongAWall)
{
  for (std::size_t i = 0; i < GetParam().Faces.size(); ++i)
  {
    SCOPED_TRACE(testing::Message() << "face " << i);
    Scene.Clear();
    this->LookAhead();
    this->AddFace(GetParam().Faces[i]);
    this->AddWall(0.4);
    EXPECT_EQ(Scene.ExpectSame(), 0) << "the face may be drawn before the wall";
    this->AddHidden();
    EXPECT_EQ(Scene.ExpectSame(), 20) << "the wall hides what is surely behind it";
  }
}

INSTANTIATE_TEST_SUITE_P(Planes, CullerCuts,
  testing::Values(CutPlane{ "Side", 0.0, 700.0, -Slope, 1.3, -3.0,
                    {
                      { 0.00373, 3.584, 59.36, 3.569, 56.819, 2.236 },
                      { 0.00089, 29.998, 15.869, 31.74, 54.892, 28.114 },
                      { 0.00326, 9.17, 28.442, 8.758, 41.329, 7.673 },
                      { 0.00724, 14.834, 15.367, 14.853, 50.514, 13.811 },
                      { 0.00036, 78.959, 17.371, 80.016, 13.448, 77.196 },
                      { 0.00408, 39.326, 29.406, 41.098, 50.463, 41.291 },
                      { 0.00083, 18.459, 33.285, 17.804, 45.774, 16.863 },
                      { 0.00597, 33.455, 22.218, 33.76, 59.233, 33.925 },
                      { 0.00252, 11.877, 28.828, 11.533, 40.583, 10.076 },
                      { 0.00277, 41.541, 18.542, 41.7, 42.165, 41.221 },
                      { 0.00106, 82.791, 13.874, 84.634, 51.115, 81.599 },
                      { 0.00306, 32.084, 27.775, 32.566, 49.986, 30.591 },
                    } },
    CutPlane{ "Near", 24.75, Middle - 1.0, -Slope, 0.0, 0.5,
      {
        { 0.00282, 87.963, 51.716, 87.06, 43.99, 86.369 },
        { 0.00239, 40.791, 57.833, 42.049, 49.167, 39.754 },
        { 0.00137, 36.541, 39.363, 38.301, 57.248, 35.242 },
        { 0.00199, 56.627, 51.516, 55.871, 39.78, 55.562 },
        { 0.00167, 5.127, 26.564, 5.541, 49.072, 3.17 },
        { 0.00253, 19.912, 33.569, 21.796, 52.235, 21.742 },
      } },
    CutPlane{ "Far", 70.75, 1.0 - Middle, Slope, 0.0, 0.5,
      {
        { 0.08543, 19.131, 28.544, 19.011, 57.021, 17.318 },
        { 0.08338, 13.451, 33.342, 15.282, 58.073, 14.995 },
        { 0.0934, 83.197, 56.478, 84.91, 41.933, 84.002 },
      } }),
  [](const testing::TestParamInfo<CutPlane>& plane) { return plane.param.Name; });

}
