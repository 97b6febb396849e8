#include "methods/Stage.h"

#include "Errors.h"
#include "methods/VitrineMethods.h"
#include "scene/ColorBy.h"

#include "vtkImageData.h"
#include "vtkPropCollection.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace program
{

namespace
{
// Of the distance that the far plane has. VTK's own choice for depths of 24 bits and more; when VTK 9.1 asks
// the window, which it does once there is something to draw, it can leave an OpenGL error behind.
const double NearestShare = 0.001;

vitrine::Image ToImage(vtkImageData* rgba, PictureSize size)
{
  vitrine::Image image{ size.Width, size.Height, {} };
  const std::size_t pixels = static_cast<std::size_t>(size.Width) * size.Height;
  image.Rgb.reserve(3 * pixels);
  const float* values = static_cast<const float*>(rgba->GetScalarPointer());
  for (std::size_t i = 0; i < pixels; ++i)
  {
    image.Rgb.insert(image.Rgb.end(), values + 4 * i, values + 4 * i + 3);
  }
  return image;
}
}

Stage::Stage(const Scene& scene, std::unique_ptr<Method> method, PictureSize size, int multisamples)
  : DrawingMethod(std::move(method))
  , Size(size)
  , Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetSize(size.Width, size.Height);
  this->Window->SetMultiSamples(multisamples);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(Background, Background, Background);
  this->Renderer->SetNearClippingPlaneTolerance(NearestShare);
  this->DrawingMethod->Attach(this->Renderer);
  this->SetScene(scene);
}

Stage::~Stage()
{
  this->Window->Finalize();
}

void Stage::SetScene(const Scene& scene)
{
  RequireFewLights(scene, this->DrawingMethod->MostLights());
  SetLights(scene.Lights, this->Renderer);
  this->Renderer->RemoveAllViewProps();
  this->Actors = AddActors(scene, this->Renderer);
  CutSections(scene, this->Actors, this->Renderer);
  ShowLooks(scene, this->Actors, this->Renderer);
  AddScalarBar(scene, this->Renderer);
  this->ClippingRange = scene.Placement.ClippingRange;
}

void Stage::SetPartOrder(const std::vector<std::size_t>& order)
{
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->RemoveAllItems();
  for (const std::size_t part : order)
  {
    props->AddItem(this->Actors[part]);
  }
}

void Stage::SetSize(PictureSize size)
{
  this->Size = size;
  this->Window->SetSize(size.Width, size.Height);
}

double Stage::Draw(vtkCamera* camera)
{
  this->Renderer->GetActiveCamera()->DeepCopy(camera);
  if (this->ClippingRange)
  {
    this->Renderer->GetActiveCamera()->SetClippingRange(this->ClippingRange->data());
  }
  else
  {
    this->Renderer->ResetCameraClippingRange();
  }
  const auto begin = std::chrono::steady_clock::now();
  this->Window->Render();
  if (this->Window->GetNeverRendered() || !this->Window->SupportsOpenGL())
  {
    throw RuntimeError("there is no OpenGL to draw with here");
  }
  this->Window->WaitForCompletion(); // needs the entry points of OpenGL
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  return passed.count();
}

std::optional<std::size_t> Stage::PartOf(const vtkProp* actor) const
{
  const auto found = std::find(this->Actors.begin(), this->Actors.end(), actor);
  return found == this->Actors.end()
    ? std::nullopt
    : std::optional<std::size_t>(static_cast<std::size_t>(found - this->Actors.begin()));
}

std::vector<std::uint8_t> Stage::ReadPixels()
{
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(
    0, 0, this->Size.Width - 1, this->Size.Height - 1, /* front= */ 0, pixels);
  const std::uint8_t* begin = pixels->GetPointer(0);
  return { begin, begin + pixels->GetNumberOfValues() };
}

Device Stage::GetDevice()
{
  return DescribeDevice(this->Window);
}

int Stage::GetSamples()
{
  return std::max(this->Window->GetMultiSamples(), 1);
}

void RequireFewLights(const Scene& scene, std::size_t most)
{
  if (scene.Lights.size() > most)
  {
    throw InputError(scene.Name,
      "it has " + std::to_string(scene.Lights.size()) + " lights, and " + std::to_string(most) +
        " are the most that VTK's own shaders are let draw: more take minutes to compile");
  }
}

vitrine::Image ToImage(const std::vector<std::uint8_t>& pixels, PictureSize size)
{
  vitrine::Image image{ size.Width, size.Height, {} };
  image.Rgb.reserve(pixels.size());
  for (std::uint8_t value : pixels)
  {
    image.Rgb.push_back(value / 255.0f);
  }
  return image;
}

std::vector<std::uint8_t> ToPixels(const vitrine::Image& image)
{
  std::vector<std::uint8_t> pixels;
  pixels.reserve(image.Rgb.size());
  for (const float value : image.Rgb)
  {
    const float shown = std::isnan(value) ? 0.0f : std::clamp(value, 0.0f, 1.0f);
    pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0f * shown)));
  }
  return pixels;
}

TruthStage::TruthStage(
  const Scene& scene, PictureSize size, int multisamples, const Coincidence& coincidence)
  : Window(scene,
      std::make_unique<VitrineMethod>(vtkSmartPointer<vtkTransparencyPass>(this->Pass.Get())), size,
      multisamples)
{
  this->Pass->SetCoincidenceSteps(coincidence.Steps);
  this->Pass->SetCoincidenceSlope(coincidence.Slope);
}

std::unique_ptr<vitrine::Image> TruthStage::Draw(vtkCamera* camera)
{
  this->Window.Draw(camera);
  if (!this->WhyNotRun().empty())
  {
    return nullptr;
  }
  vtkImageData* result = this->Pass->GetResult();
  const PictureSize size = this->Window.GetSize();
  // without translucent geometry the window's own picture is exact
  return std::make_unique<vitrine::Image>(
    result ? ToImage(result, size) : program::ToImage(this->Window.ReadPixels(), size));
}

}
