/** A cube with a plate in it, which a section cuts, and the pictures of it by hand. */
#ifndef VITRINE_TEST_SECTION_SCENE_H
#define VITRINE_TEST_SECTION_SCENE_H

#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkSection.h"

/** Red, blue and black, as Picture::At() has them. */
constexpr Rgba CubeColor = { 1.0, 0.0, 0.0, 1.0 };
constexpr Rgba PlateColor = { 0.0, 0.0, 1.0, 1.0 };

/** Pixels from (X0, Y0) to before (X1, Y1), from the left and the bottom. */
struct PixelBox
{
  int X0;
  int Y0;
  int X1;
  int Y1;
};

/**
 * Looks along -z. A red cube of [-0.5, 0.5] in each direction covers the pixels 8 to 23, and a blue plate within it at
 * z = 0 the pixels 12 to 19. The plane z = 0.25 removes the front of the cube. Nothing is lit.
 */
struct SectionScene : TestScene
{
  static constexpr int Size = 32;

  explicit SectionScene(int multisamples = 0)
    : TestScene(Size, Size, multisamples)
  {
    this->Cube = this->AddCube(-0.5, 0.5, CubeColor);
    this->AddRectangle(-0.25, -0.25, 0.25, 0.25, 0.0, PlateColor);
    this->Plane->SetOrigin(0.0, 0.0, 0.25);
    this->Plane->SetNormal(0.0, 0.0, -1.0);
    this->Section->AddPlane(this->Plane);
    this->Section->SetEdgeWidth(0);
    this->Section->Attach(this->Renderer);
  }

  /** Draw a frame without the section, which leaves it with nothing on the device. */
  void RenderWhole()
  {
    this->Section->Detach();
    this->Render();
    this->Section->Attach(this->Renderer);
  }

  /** A box from x0 to x1 that is as high and as deep as the cube. */
  vtkSmartPointer<vtkActor> AddCube(double x0, double x1, const Rgba& color)
  {
    vtkNew<vtkCubeSource> source;
    source->SetBounds(x0, x1, -0.5, 0.5, -0.5, 0.5);
    vtkSmartPointer<vtkActor> actor = this->AddSource(source, color);
    actor->GetProperty()->LightingOff();
    return actor;
  }

  /** The picture of boxes of pixels, each over those before it, on the background. */
  static Picture PictureOf(const std::vector<std::pair<PixelBox, Rgba>>& boxes)
  {
    Picture picture{ Size, Size, {} };
    std::vector<std::pair<PixelBox, Rgba>> all = boxes;
    all.insert(all.begin(), { { 0, 0, Size, Size }, TestBackground });
    picture.Bytes.resize(std::size_t(4) * Size * Size);
    for (const auto& [box, color] : all)
    {
      for (int y = box.Y0; y < box.Y1; ++y)
      {
        for (int x = box.X0; x < box.X1; ++x)
        {
          for (int channel = 0; channel < 4; ++channel)
          {
            picture.Bytes[std::size_t(4) * (Size * y + x) + channel] =
              static_cast<unsigned char>(255.0 * color[channel] + 0.5);
          }
        }
      }
    }
    return picture;
  }

  /** The cube with its cap, which hides the plate. */
  static Picture Capped() { return PictureOf({ { CubeBox, CubeColor } }); }

  /** The cube without a cap: the plate is seen in it. */
  static Picture Open() { return PictureOf({ { CubeBox, CubeColor }, { PlateBox, PlateColor } }); }

  static constexpr PixelBox CubeBox{ 8, 8, 24, 24 };
  static constexpr PixelBox PlateBox{ 12, 12, 20, 20 };

  vtkSmartPointer<vtkActor> Cube;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkSection> Section;
};

#endif
