#include "methods/VTKMethods.h"

#include "methods/TimedPass.h"

#include "vtkDualDepthPeelingPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucentPass.h"

namespace
{
/** Counts how often the translucent geometry is drawn. */
class CountingTranslucentPass : public vtkTranslucentPass
{
public:
  static CountingTranslucentPass* New();
  vtkTypeMacro(CountingTranslucentPass, vtkTranslucentPass);

  void Render(const vtkRenderState* s) override
  {
    ++this->Count;
    this->Superclass::Render(s);
  }

  int Count = 0;
};
vtkStandardNewMacro(CountingTranslucentPass);

/** The steps of a frame, which begins with no geometry pass counted. */
class CountingRenderStepsPass : public vtkRenderStepsPass
{
public:
  static CountingRenderStepsPass* New();
  vtkTypeMacro(CountingRenderStepsPass, vtkRenderStepsPass);

  void Render(const vtkRenderState* s) override
  {
    this->Geometry->Count = 0;
    const int* size = s->GetRenderer()->GetSize();
    this->Pixels = static_cast<std::int64_t>(size[0]) * size[1];
    this->Superclass::Render(s);
  }

  vtkNew<CountingTranslucentPass> Geometry;
  std::int64_t Pixels = 0;
};
vtkStandardNewMacro(CountingRenderStepsPass);

/** Depth peeling where it works. In a multisampled window it would leave out all that is translucent. */
class SingleSamplePeelingPass : public vtkDualDepthPeelingPass
{
public:
  static SingleSamplePeelingPass* New();
  vtkTypeMacro(SingleSamplePeelingPass, vtkDualDepthPeelingPass);

  void Render(const vtkRenderState* s) override
  {
    if (s->GetRenderer()->GetRenderWindow()->GetMultiSamples() <= 1)
    {
      this->WhyNot.clear();
      this->Superclass::Render(s);
      return;
    }
    if (this->WhyNot.empty())
    {
      this->WhyNot = "VTK's depth peeling needs a window without multisampling";
      vtkErrorMacro(<< this->WhyNot << ". Translucent geometry is blended unsorted.");
    }
    this->TranslucentPass->Render(s);
  }

  std::string WhyNot; ///< the last frame was not peeled; empty if it was
};
vtkStandardNewMacro(SingleSamplePeelingPass);
}

namespace program
{

namespace
{
// bytes of a pixel, from the formats of the textures that VTK 9.1's passes allocate
const int BlendBytes = 0;
const int OITBytes = 8 + 2 + 4;             // RGBA16F, R16F, depth
const int PeelingBytes = 4 * 4 + 2 * 8 + 4; // four RGBA8, two RG32F, depth

/** One of VTK's passes around the drawing of the geometry. */
class VTKMethod : public Method
{
public:
  VTKMethod(vtkOpenGLRenderPass* pass, int bytesPerPixel)
    : Pass(pass)
    , BytesPerPixel(bytesPerPixel)
  {
  }

  void Attach(vtkRenderer* renderer) override
  {
    this->Steps->SetTranslucentPass(this->Steps->Geometry);
    if (this->Pass)
    {
      this->Steps->SetTranslucentPass(this->Pass);
    }
    if (this->AreStagesMeasured)
    {
      this->Opaque->SetStage("opaque", this->Steps->GetOpaquePass());
      this->Steps->SetOpaquePass(this->Opaque);
      this->Translucent->SetStage("translucent", this->Steps->GetTranslucentPass());
      this->Steps->SetTranslucentPass(this->Translucent);
    }
    renderer->SetPass(this->Steps);
  }

  void MeasureStages() override { this->AreStagesMeasured = true; }

  vtkTranslucentPass* Geometry() { return this->Steps->Geometry; }

  MethodStatistics Statistics() const override
  {
    MethodStatistics statistics;
    statistics.GeometryPasses = this->Steps->Geometry->Count;
    statistics.Bytes = this->BytesPerPixel * this->Steps->Pixels;
    for (TimedPass* const pass : { this->Opaque.Get(), this->Translucent.Get() })
    {
      const StageTimes times = pass->Times();
      statistics.Stages.insert(statistics.Stages.end(), times.begin(), times.end());
    }
    return statistics;
  }

private:
  vtkNew<CountingRenderStepsPass> Steps;
  vtkSmartPointer<vtkOpenGLRenderPass> Pass;
  vtkNew<TimedPass> Opaque;
  vtkNew<TimedPass> Translucent;
  bool AreStagesMeasured = false;
  int BytesPerPixel;
};

class PeelingMethod : public VTKMethod
{
public:
  explicit PeelingMethod(SingleSamplePeelingPass* pass)
    : VTKMethod(pass, PeelingBytes)
    , Pass(pass)
  {
    pass->SetTranslucentPass(this->Geometry());
  }

  std::string WhyNotRun() const override { return this->Pass->WhyNot; }

private:
  vtkSmartPointer<SingleSamplePeelingPass> Pass;
};
}

std::unique_ptr<Method> MakeBlend()
{
  return std::make_unique<VTKMethod>(nullptr, BlendBytes);
}

std::unique_ptr<Method> MakeVTKOIT()
{
  vtkNew<vtkOrderIndependentTranslucentPass> pass;
  auto method = std::make_unique<VTKMethod>(pass, OITBytes);
  pass->SetTranslucentPass(method->Geometry());
  return method;
}

std::unique_ptr<Method> MakeVTKPeeling(int peels)
{
  vtkNew<SingleSamplePeelingPass> pass;
  pass->SetMaximumNumberOfPeels(peels);
  pass->SetOcclusionRatio(0.0);
  return std::make_unique<PeelingMethod>(pass);
}

std::vector<const char*> PassesOfVTKMethods()
{
  return { "CountingTranslucentPass", "CountingRenderStepsPass", "SingleSamplePeelingPass" };
}

}
