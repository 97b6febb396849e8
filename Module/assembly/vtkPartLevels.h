/**
 * @class   vtkPartLevels
 * @brief   draws parts of assemblies no finer than the picture, while the camera moves
 *
 * Each part gets levels of detail, made in the background. While the camera moves, each part is drawn at the coarsest
 * level with which no point of its surface is farther from where it should be than some pixels. Where the camera stands
 * still, as from one frame to the next, all parts are drawn as they are. Another size of the window is no motion, and
 * neither are the tiles of which vtkWindowToImageFilter puts together large pictures.
 *
 * @code
 * vtkNew<vtkPartLevels> levels;
 * levels->AddAssembly(actors);
 * levels->Attach(renderer);
 * @endcode
 *
 * A level is made by OpenMesh's decimater, by quadrics. Its distance from the part, both ways (the Hausdorff distance),
 * has a bound that is computed, not estimated. Normals at hard edges, borders of colours and open edges are kept. Its
 * area is nearly that of the part, unless that takes more than 16 triangles a pixel. A tiny part is a tetrahedron of
 * the part's area, or a rectangle if the part is a sheet, where that is within the bound. So a cloud of parts hides as
 * much as it should.
 *
 * In frames with levels, parts of one look are one actor, and the assembly's own actors are hidden. Between frames all
 * is as it was. So picks, measures and bounds are of the parts themselves. Drawn as they are, too, are:
 * - all parts, while a selector renders, and with a camera that has matrices of its own, as of vtkCamera's
 *   SetUserTransform() or SetModelTransformMatrix();
 * - parts that a plane of a section or the camera's near or far plane meets, as a small move of a face may be a large
 *   one of its edge in the plane;
 * - actors with parts that are chosen for an x-ray or for a plane of a section;
 * - actors with parts that have textures, lines or vertices, or whose geometry has changed since it was added, and
 *   those that were moved or scaled, or have got clipping planes or shader code.
 *
 * @sa
 * vtkAssemblyActors vtkSeeThroughPass
 */
#ifndef vtkPartLevels_h
#define vtkPartLevels_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the internals

class vtkAssemblyActors;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkPartLevels : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkPartLevels* New();
  vtkTypeMacro(vtkPartLevels, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Add the parts of an assembly, and begin to make their levels. Geometry must not change until they are made. Parts
   * whose geometry changes later are drawn as they are from then on. Parts that are added already are not added again.
   */
  void AddAssembly(vtkAssemblyActors* assembly);

  ///@{
  /**
   * Get/Set by how many pixels points may move. The range is 0.001 to 64, the default is 0.5.
   */
  void SetPixels(double pixels);
  double GetPixels();
  ///@}

  ///@{
  /**
   * Get/Set whether parts are drawn as they are in the first frame after Attach(), and in one whose camera is that of
   * the frame before. The default is true.
   */
  void SetExactWhileStill(bool exact);
  bool GetExactWhileStill();
  vtkBooleanMacro(ExactWhileStill, bool);
  ///@}

  ///@{
  /**
   * Get/Set whether levels that were made of the same geometry before are used, and new ones are kept, in
   * vitrine/levels of $XDG_CACHE_HOME or ~/.cache. That is done for geometry of 100,000 cells and more, up to 1 GiB,
   * and holds for assemblies that are added later. The default is true.
   */
  void SetUseCache(bool use);
  bool GetUseCache();
  vtkBooleanMacro(UseCache, bool);
  ///@}

  ///@{
  /**
   * Attach to a renderer, which draws by levels from its next frame on, or undo that. The object is attached to one
   * renderer at a time, which keeps it alive. A renderer has one such object at a time; an earlier one is detached.
   */
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /**
   * Get the renderer to which the object is attached, or null.
   */
  vtkRenderer* GetRenderer();

  /**
   * Get the object that is attached to a renderer, or null.
   */
  static vtkPartLevels* GetAttached(vtkRenderer* renderer);

  ///@{
  /**
   * Get how much of the levels is made, from 0 to 1, or wait until all are. Before that, frames are drawn without them.
   */
  double GetProgress();
  void WaitUntilMade();
  ///@}

  ///@{
  /**
   * Get figures of the last frame: whether levels were drawn, the number of triangles that were drawn of all parts with
   * levels, those that they have without, and the greatest distance that a point may be from where it should be, in
   * pixels. Single precision counts in it. Without levels, both numbers are equal, and the distance is 0.
   */
  bool GetDrewLevels();
  vtkIdType GetNumberOfTriangles();
  vtkIdType GetNumberOfWholeTriangles();
  double GetGreatestDistance();
  ///@}

protected:
  vtkPartLevels();
  ~vtkPartLevels() override;

private:
  vtkPartLevels(const vtkPartLevels&) = delete;
  void operator=(const vtkPartLevels&) = delete;

  void WhenRendererIsDeleted();

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
