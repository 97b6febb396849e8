/**
 * @class   vtkDistributedTransparencyPass
 * @brief   exact transparency of geometry that is spread over the ranks of a controller
 *
 * Each rank has a part of the scene, any part, and draws it into lists of fragments, as vtkPrefixSumTransparencyPass
 * does. The geometry stays where it is. A frame has these steps:
 *
 * 1. The ranks compare the sizes of their windows, their cameras and their settings.
 * 2. Each tile of 32 x 32 pixels has a rank that owns it. All send the opaque pixels of a tile to its owner, which
 *    keeps the nearest, and tells the others where its depth is nearer than theirs. So no rank keeps fragments that
 *    opaque geometry of another one hides.
 * 3. Each rank fills its lists, and sends those of a tile to its owner, node by node as they are stored.
 * 4. The owner joins the lists, sorts and composites them.
 * 5. The tiles are sent to the rank that wants the picture.
 *
 * In multisampled windows, opaque samples are combined one by one, and the owner of a pixel owns its samples.
 *
 * Fragments of equal depth are ordered by their packed colour. So the picture is to the bit that of one rank with all
 * of the geometry, however it is spread. Opaque faces of exactly one depth are an exception: VTK shows that which is
 * drawn last, and ranks have no common order. The larger colour is taken.
 *
 * All ranks render the same frames: if one renders and another does not, it waits for ever. If one cannot draw a frame,
 * all get its reason as an error and as GetFallbackReason(), and each shows its own geometry alone. If a rank ends, the
 * launcher ends the others: mpirun does so if a process is killed, and `python3 -m mpi4py` if a script raises.
 *
 * @code
 * vtkNew<vtkDistributedTransparencyPass> ranks;
 * ranks->SetController(vtkMultiProcessController::GetGlobalController()); // a vtkMPIController
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(ranks);
 * renderer->SetPass(seeThrough);
 * ranks->ResetCamera(renderer);
 * window->Render(); // on all ranks
 * @endcode
 *
 * Ghost cells, those that vtkDataSetAttributes::DUPLICATECELL marks, are left out. They are copies of cells that
 * another rank draws. That is done for actors with a vtkPolyDataMapper. Elsewhere they are an error of the frame: call
 * vtkPolyData::RemoveGhostCells().
 *
 * VTK moves the coordinates of a mapper before they become floats, by bounds that pieces of one mesh do not share.
 * Where single meshes are divided, switch that off by SetVBOShiftScaleMethod() of their mappers, or fragments differ in
 * their last bits.
 *
 * Limits: no ambient occlusion and no shadows. A skybox is on all ranks. Volumes and what is drawn after the
 * translucent geometry are those of the rank itself. PartNumbers tell the parts of the rank itself; a vtkLayerPicker
 * with the controller tells those of all. A section gives caps to parts that are whole on a rank.
 *
 * Sources: S. Molnar, M. Cox, D. Ellsworth, H. Fuchs: A Sorting Classification of Parallel Rendering, IEEE Computer
 * Graphics and Applications 14 (1994), sort-last; W. M. Hsu: Segmented Ray Casting for Data Parallel Volume Rendering,
 * Parallel Rendering Symposium 1993, direct send.
 *
 * @sa
 * vtkPrefixSumTransparencyPass vtkSeeThroughPass vtkLayerPicker
 */
#ifndef vtkDistributedTransparencyPass_h
#define vtkDistributedTransparencyPass_h

#include "vtkPrefixSumTransparencyPass.h"

#include <memory> // for what the pass holds

class vtkMultiProcessController;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkDistributedTransparencyPass
  : public vtkPrefixSumTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkDistributedTransparencyPass* New();
  vtkTypeMacro(vtkDistributedTransparencyPass, vtkPrefixSumTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the controller of the ranks that draw together. With null, the default, and with a controller of one
   * process the pass draws as its superclass does.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * Get the number of ranks that draw together, 1 without a controller.
   */
  int GetNumberOfRanks();

  ///@{
  /**
   * Set/Get the rank that gets the picture, the same on all ranks. With -1 all get it. Other ranks have the tiles that
   * they own, and elsewhere what they drew themselves. The range is -1 to the largest int, the default is 0. A rank
   * that the controller does not have is an error of the frame.
   */
  void SetPictureRank(int rank);
  vtkGetMacro(PictureRank, int);
  ///@}

  /**
   * Move the camera so that it sees the geometry of all ranks, as vtkRenderer::ResetCamera() does for that of one. All
   * ranks call this. The cameras are those of rank 0 afterwards.
   */
  void ResetCamera(vtkRenderer* renderer);

  /**
   * Give the camera of rank 0 to all ranks, with a clipping range that holds the geometry of all. All ranks call this.
   */
  void SynchronizeCamera(vtkRenderer* renderer);

  /**
   * Get the bounds of the visible props of all ranks, until the next call. All ranks call this.
   */
  double* ComputeVisiblePropBounds(vtkRenderer* renderer) VTK_SIZEHINT(6);

  /**
   * Draw the translucent geometry of all ranks. All ranks call this, those without translucent geometry too.
   */
  void Render(const vtkRenderState* s) override;

  const char* GetMethodName() override { return "distributed"; }

  ///@{
  /**
   * Get how many fragments this rank sent to owners in the last frame, with how many bytes, and the bytes of all other
   * messages of the frame: opaque pixels, the picture, and what the ranks compare.
   */
  vtkGetMacro(SentFragments, vtkTypeInt64);
  vtkGetMacro(SentFragmentBytes, vtkTypeInt64);
  vtkGetMacro(SentOtherBytes, vtkTypeInt64);
  ///@}

  /**
   * Get the bytes of a node, as which fragments are stored and sent in the last frame.
   */
  int GetNodeBytes();

protected:
  vtkDistributedTransparencyPass();
  ~vtkDistributedTransparencyPass() override;

  bool HasFragments(const vtkRenderState* s) override;
  std::string GetSubstituteName() override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  std::string RenderLists(const vtkRenderState* s, const vitrine::RenderTarget& target,
    vitrine::FragmentStatistics& frame) override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int PictureRank = 0;
  vtkTypeInt64 SentFragments = 0;
  vtkTypeInt64 SentFragmentBytes = 0;
  vtkTypeInt64 SentOtherBytes = 0;

private:
  vtkDistributedTransparencyPass(const vtkDistributedTransparencyPass&) = delete;
  void operator=(const vtkDistributedTransparencyPass&) = delete;

  std::string DrawTogether(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string FindHindrance(vtkRenderer* renderer);
  std::string Join(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string CombineOpaque(const vitrine::RenderTarget& target);
  std::string AgreeOnLists(const std::string& problem);
  bool FitsInOnePiece();
  std::string RenderBands(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string JoinLists(const vitrine::RenderTarget& target, const vitrine::PixelRegion& region);
  std::string SendPicture(const vitrine::RenderTarget& target, const std::string& problem);
  void TakeTotals();
  void ForgetFrame();

  struct Shared;
  std::unique_ptr<Shared> Ranks;
};

#endif
