#include "RanksOfView.h"

#include "vtkCollection.h"
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkImageProcessingPass.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkPropCollection.h"
#include "vtkTreeCompositer.h"
#include "vtkVolume.h"

namespace vitrine
{

namespace
{

/** Leaves the picture of rank 0 as it is if the ranks drew it together. */
class PictureOfRanks : public vtkTreeCompositer
{
public:
  static PictureOfRanks* New();
  vtkTypeMacro(PictureOfRanks, vtkTreeCompositer);

  vtkDistributedTransparencyPass* Transparency = nullptr;

  void CompositeBuffer(vtkDataArray* colors, vtkFloatArray* depths, vtkDataArray* otherColors,
    vtkFloatArray* otherDepths) override
  {
    const char* const reason = this->Transparency->GetFallbackReason();
    if (reason && *reason)
    {
      this->Superclass::CompositeBuffer(colors, depths, otherColors, otherDepths);
    }
  }

protected:
  PictureOfRanks() = default;
};

vtkStandardNewMacro(PictureOfRanks);

}

RanksOfView::RanksOfView(vtkPVSession* session, vtkRenderPass* frame)
{
  this->Transparency->SetController(vtkMultiProcessController::GetGlobalController());
  this->Together->SetDisableIceT(true);
  this->Together->Initialize(session);
  this->Together->SetEnabled(false);
  this->Together->SetRenderPass(frame);
  auto* const compositing =
    vtkCompositedSynchronizedRenderers::SafeDownCast(this->Together->GetParallelSynchronizer());
  vtkNew<PictureOfRanks> picture;
  picture->Transparency = this->Transparency;
  compositing->SetCompositer(picture);
  // Without a client, which draws the background, a picture with it needs no rounding of alpha.
  compositing->SetFixBackground(
    vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_BATCH);
}

int RanksOfView::Count()
{
  return vtkProcessModule::GetProcessModule()->GetNumberOfLocalPartitions();
}

std::string RanksOfView::FindHindrance(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    if (prop->GetVisibility() && vtkVolume::SafeDownCast(prop))
    {
      return "Vitrine does not draw volumes on several ranks, so ParaView itself draws this view. "
             "Hide the volumes, or start the server or pvbatch with one rank";
    }
  }
  return {};
}

void RanksOfView::ConfigureCompressor(const char* configuration)
{
  this->Together->ConfigureCompressor(configuration);
}

RanksOfView::Frame::Frame(
  RanksOfView& ranks, vtkRenderer* renderer, vtkPVSynchronizedRenderer*& synchronizer)
  : Ranks(ranks)
  , Renderer(renderer)
  , Synchronizer(synchronizer)
  , Own(synchronizer)
  , OwnPass(renderer->GetPass())
{
  this->Own->SetEnabled(false);
  this->Synchronizer = ranks.Together;
  ranks.Together->SetImageProcessingPass(this->Own->GetImageProcessingPass());
  ranks.Together->SetRenderer(renderer); // which gives it the passes
}

// ParaView's synchronizer gives its own passes to an image processing pass as it takes it.
RanksOfView::Frame::~Frame()
{
  const vtkSmartPointer<vtkImageProcessingPass> processing = this->Own->GetImageProcessingPass();
  this->Ranks.Together->SetRenderer(nullptr);
  this->Ranks.Together->SetImageProcessingPass(nullptr);
  this->Own->SetImageProcessingPass(nullptr);
  this->Own->SetImageProcessingPass(processing);
  this->Renderer->SetPass(this->OwnPass);
  this->Synchronizer = this->Own;
}

}
