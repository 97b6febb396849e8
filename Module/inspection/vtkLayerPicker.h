/**
 * @class   vtkLayerPicker
 * @brief   tells all layers under pixels of a renderer, from front to back
 *
 * The picker is for scenes that are seen through. vtkHardwareSelector tells the nearest surface of a pixel; this class
 * tells each surface down to the nearest opaque one, in the order in which they are seen, with the share of the picture
 * that each has. With BehindOpaque it also tells what is behind the opaque one.
 *
 * @code
 * window->Render();
 * vtkNew<vtkLayerPicker> picker;
 * picker->SetRenderer(renderer);
 * picker->SetPosition(320, 240);
 * if (picker->Pick())
 * {
 *   for (vtkIdType i = 0; i < picker->GetNumberOfLayers(); ++i)
 *   {
 *     std::cout << picker->GetBlock(i) << ": " << picker->GetShare(i) << "\n";
 *   }
 * }
 * @endcode
 *
 * A layer is a fragment: a place where a surface covers a pixel. Its part is a prop, or a block of a prop whose mapper
 * draws composite data. A closed part has two layers or more, of front and back faces. Layers agree with what is drawn:
 * with clipping planes of mappers, hidden props and blocks, opacities and textures. Volumes, and props of the overlay,
 * are no layers. What a culler has left out is found.
 *
 * If the renderer's transparency pass keeps part numbers (vtkABufferTransparencyPass::SetPartNumbers()), translucent
 * layers come from the lists of its last frame. Otherwise, and for all opaque layers, the props under the pixels are
 * drawn once more. The picture, OpenGL's state and the statistics of the passes stay as they are.
 *
 * Layers of equal depth have the order of the exact methods: by alpha, blue, green, red. Of opaque ones, that which was
 * drawn last is in front, as in the depth test. Tolerances for coincidence are not regarded. In multisampled windows a
 * layer has the depth of one place in the pixel, and shares are means over the pixel's samples.
 *
 * With a controller, the layers of all its ranks are told, as if one rank had all parts. Then each rank calls Pick(),
 * with one rectangle, camera and settings.
 *
 * Pixels are display coordinates: whole numbers from the window's lower left corner.
 *
 * @sa
 * vtkABufferTransparencyPass vtkDistributedTransparencyPass vtkSeeThroughPass vtkHardwareSelector
 */
#ifndef vtkLayerPicker_h
#define vtkLayerPicker_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for the internals
#include <string> // for messages

class vtkFloatArray;
class vtkIdTypeArray;
class vtkMultiProcessController;
class vtkProp;
class vtkRenderer;
class vtkUnsignedIntArray;

namespace vitrine
{
class FrameOfRenderer;
}

class VTKVITRINERENDERING_EXPORT vtkLayerPicker : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkLayerPicker* New();
  vtkTypeMacro(vtkLayerPicker, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the renderer whose layers are told. It is not kept alive. The default is null.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * Set/Get the controller of the ranks whose layers are told, as in vtkDistributedTransparencyPass. The default is
   * null: the layers of this rank alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * Set/Get the rectangle of pixels, in display coordinates. Both corners belong to it. The default is the pixel 0, 0.
   */
  vtkSetVector4Macro(Area, int);
  vtkGetVector4Macro(Area, int);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Set the rectangle to one pixel, in display coordinates. From Python, vitrine.layers_at() does so.
   */
  void SetPosition(int x, int y)
  {
    this->SetArea(x, y, x, y);
  }
#endif

  ///@{
  /**
   * Set/Get whether layers behind the nearest opaque one are told, too. They have the share 0. The default is false.
   */
  vtkSetMacro(BehindOpaque, bool);
  vtkGetMacro(BehindOpaque, bool);
  vtkBooleanMacro(BehindOpaque, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether opaque layers are told. If off, and if the transparency pass keeps part numbers, nothing is drawn.
   * Shares are then those in front of whatever is opaque. The default is true.
   */
  vtkSetMacro(OpaqueLayers, bool);
  vtkGetMacro(OpaqueLayers, bool);
  vtkBooleanMacro(OpaqueLayers, bool);
  ///@}

  /**
   * Find the layers of the rectangle in the last frame. Returns false, with a reason in GetProblem(), if the renderer
   * has drawn no frame, if a pixel is outside its viewport, or if the driver cannot capture fragments (OpenGL 4.3).
   * With a controller, all ranks call this, and get the same layers or the reasons of the ranks that have one.
   */
  bool Pick();

  /**
   * Get why the last Pick() failed. The string is empty if it did not.
   */
  std::string GetProblem();

  /**
   * Get how many of the layers' fragments were taken from the lists of the last frame, without drawing.
   */
  vtkIdType GetNumberOfListedLayers();

  /**
   * Get the number of layers of all pixels that were picked. The layers of a pixel are in a row, from front to back.
   * Pixels go row by row from the lower left one.
   */
  vtkIdType GetNumberOfLayers();

  ///@{
  /**
   * Get the part of a layer: its prop, and the flat index of its block, which is 0 for a prop without blocks. The prop
   * is null if it is gone, if another rank has it, or if there is no such layer. The range is 0 to
   * GetNumberOfLayers() - 1.
   */
  vtkProp* GetProp(vtkIdType layer);
  unsigned int GetBlock(vtkIdType layer);
  ///@}

  /**
   * Get the rank that has the part of a layer. It is 0 without a controller, and -1 if there is no such layer.
   */
  int GetRank(vtkIdType layer);

  /**
   * Get the cell of a layer: the id of the cell of its part's data whose intersection with the ray through the pixel's
   * centre is nearest in depth. It is searched on the CPU. Returns -1 if the ray meets no cell, as at the rim of a
   * surface, for lines and points, and for parts of other ranks.
   */
  vtkIdType GetCellId(vtkIdType layer);

  /**
   * Get the depth of a layer in the window, from 0 at the near plane to 1 at the far plane.
   */
  double GetWindowDepth(vtkIdType layer);

  /**
   * Get the place of a layer on the ray through the pixel's centre, in world coordinates (WC).
   */
  double* GetWorldPosition(vtkIdType layer) VTK_SIZEHINT(3);

  /**
   * Get the distance of a layer along the ray, in world units: from the eye, or in parallel projection from the near
   * plane.
   */
  double GetDistance(vtkIdType layer);

  /**
   * Get the colour of a layer as it is lit, not multiplied by its opacity.
   */
  double* GetColor(vtkIdType layer) VTK_SIZEHINT(3);

  /**
   * Get the opacity of a layer, from 0 to 1. It is 1 for opaque layers.
   */
  double GetOpacity(vtkIdType layer);

  /**
   * Get the share of the picture that a layer has, from 0 to 1: its opacity by the transmittance of all in front. The
   * shares of a pixel and that of the background add up to 1.
   */
  double GetShare(vtkIdType layer);

  /**
   * Get the part of the pixel that a layer covers, from 0 to 1: below 1 only in multisampled windows.
   */
  double GetCoverage(vtkIdType layer);

  ///@{
  /**
   * Get whether a layer is a front face, and whether it is opaque.
   */
  bool GetFrontFace(vtkIdType layer);
  bool GetOpaque(vtkIdType layer);
  ///@}

  /**
   * Get the layer that a click gives: the first layer of the first part whose layers together have at least a share of
   * the picture. It is looked for in the first pixel of the rectangle. The range of the share is 0 to 1. Returns -1 if
   * no part has as much.
   */
  vtkIdType PickThrough(double share);

  ///@{
  /**
   * Get the layers as arrays. Offsets has for each pixel the index of its first layer, and at the end the number of
   * layers. The others have a value for each layer, and Colors has the three of GetColor(). The arrays belong to the
   * caller's next Pick().
   */
  vtkIdTypeArray* GetOffsets();
  vtkUnsignedIntArray* GetPartNumbers();
  vtkFloatArray* GetOpacities();
  vtkFloatArray* GetWindowDepths();
  vtkFloatArray* GetShares();
  vtkFloatArray* GetColors();
  ///@}

  ///@{
  /**
   * Get the part that has a number of GetPartNumbers(). The prop is null if it is gone, if another rank has it, or if
   * there is no such number.
   */
  vtkProp* GetPropOfPart(unsigned int number);
  unsigned int GetBlockOfPart(unsigned int number);
  ///@}

  /**
   * Release what the picker holds in the context of its window.
   */
  void ReleaseGraphicsResources();

protected:
  vtkLayerPicker();
  ~vtkLayerPicker() override;

  int Area[4] = { 0, 0, 0, 0 };
  bool BehindOpaque = false;
  bool OpaqueLayers = true;

private:
  vtkLayerPicker(const vtkLayerPicker&) = delete;
  void operator=(const vtkLayerPicker&) = delete;

  std::string FindLayers();
  std::string FindFragments();
  std::string JoinRanks(const std::string& problem);
  std::string Gather(const vitrine::FrameOfRenderer& frame, int bottom, int rows);
  void MakeArrays();

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
