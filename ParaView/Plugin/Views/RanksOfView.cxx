#include "RanksOfView.h"

#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkCollection.h"
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkFlagpoleLabel.h"
#include "vtkFloatArray.h"
#include "vtkImageProcessingPass.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkPropCollection.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"
#include "vtkTreeCompositer.h"

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
  vtkSmartPointer<vtkFloatArray> Depths; ///< of the last frame

  void CompositeBuffer(vtkDataArray* colors, vtkFloatArray* depths, vtkDataArray* otherColors,
    vtkFloatArray* otherDepths) override
  {
    const char* const reason = this->Transparency->GetFallbackReason();
    if (reason && *reason)
    {
      this->Superclass::CompositeBuffer(colors, depths, otherColors, otherDepths);
    }
    this->Depths = depths;
  }

protected:
  PictureOfRanks() = default;
};

vtkStandardNewMacro(PictureOfRanks);

PictureOfRanks* PictureOf(vtkPVSynchronizedRenderer* synchronizer)
{
  auto* const compositing =
    vtkCompositedSynchronizedRenderers::SafeDownCast(synchronizer->GetParallelSynchronizer());
  return PictureOfRanks::SafeDownCast(compositing->GetCompositer());
}

/**
 * Draws by its passes after the ranks have agreed on the camera. ParaView sends position and view up of rank 0. The
 * others normalize the latter once more, and vtkCamera::Elevation() leaves a view that does not follow from both to the
 * last bit.
 */
class SameCamera : public vtkSequencePass
{
public:
  static SameCamera* New();
  vtkTypeMacro(SameCamera, vtkSequencePass);

  vtkSmartPointer<vtkMultiProcessController> Ranks;

  void Render(const vtkRenderState* s) override
  {
    vtkCamera* const camera = s->GetRenderer()->GetActiveCamera();
    double up[3], position[3];
    camera->GetViewUp(up);
    this->Ranks->Broadcast(up, 3, 0);
    camera->SetViewUp(up);
    camera->GetPosition(position);
    camera->SetPosition(position[0], position[1], position[2] + 1.0);
    camera->SetPosition(position); // computes the view
    this->Superclass::Render(s);
  }

protected:
  SameCamera() = default;
};

vtkStandardNewMacro(SameCamera);

/** Returns true if ranks show a prop alike, so that one must draw it. Others show the data that a rank has. */
bool IsCommon(vtkProp* prop)
{
  return vtkBillboardTextActor3D::SafeDownCast(prop) || vtkFlagpoleLabel::SafeDownCast(prop);
}

}

RanksOfView::RanksOfView(vtkPVSession* session, vtkRenderPass* frame)
{
  this->Transparency->SetController(vtkMultiProcessController::GetGlobalController());
  this->Together->SetDisableIceT(true);
  this->Together->Initialize(session);
  this->Together->SetEnabled(false);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(frame);
  vtkNew<SameCamera> camera;
  camera->SetPasses(passes);
  camera->Ranks = this->Transparency->GetController();
  this->Together->SetRenderPass(camera);
  auto* const compositing =
    vtkCompositedSynchronizedRenderers::SafeDownCast(this->Together->GetParallelSynchronizer());
  vtkNew<PictureOfRanks> picture;
  picture->Transparency = this->Transparency;
  compositing->SetCompositer(picture);
  // Without a client, which draws the background, a picture with it needs no rounding of alpha.
  compositing->SetFixBackground(
    vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_BATCH);
}

bool RanksOfView::Draw(vtkPVSynchronizedRenderer* synchronizer)
{
  return synchronizer->GetParallelSynchronizer() &&
    vtkProcessModule::GetProcessModule()->GetNumberOfLocalPartitions() > 1;
}

vtkFloatArray* RanksOfView::Depths()
{
  return PictureOf(this->Together)->Depths;
}

void RanksOfView::ConfigureCompressor(const char* configuration)
{
  this->Together->ConfigureCompressor(configuration);
}

void RanksOfView::PrepareToDraw(vtkRenderer* renderer)
{
  if (this->Transparency->GetController()->GetLocalProcessId() == 0)
  {
    return;
  }
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    if (IsCommon(prop) && prop->GetVisibility())
    {
      prop->SetVisibility(false);
      this->Hidden.emplace_back(prop);
    }
  }
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
  for (vtkProp* const prop : this->Ranks.Hidden)
  {
    prop->SetVisibility(true);
  }
  this->Ranks.Hidden.clear();
}

}
