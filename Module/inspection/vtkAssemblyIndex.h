/**
 * @class   vtkAssemblyIndex
 * @brief   measure between the parts of an assembly, and find those that clash
 *
 * This answers questions about the shapes of parts, without drawing: what a ray passes through and how thick walls are
 * there, what is nearest to a point, what lies in a box or a sphere, how far two parts are from each other, which parts
 * clash, and whether two parts may see each other. It has an octree over parts and one over the triangles of each
 * geometry, which is made when it is first needed. Parts of one geometry share it.
 *
 * All coordinates and lengths are those of the world. Parts are numbered from 0, in the order in which they are added.
 * Lines and points have no surface. The index keeps copies: add the parts to a new index if they have changed.
 *
 * @code
 * vtkNew<vtkAssemblyIndex> index;
 * index->AddAssembly(actors);
 * vtkNew<vtkTable> clashes;
 * index->FindClashes(0.0, index->GetDefaultTolerance(), clashes);
 * @endcode
 *
 * A part is *closed* if each edge of its triangles has an even number of them, where points of one place are one. Only
 * closed parts have a solid: the points from which a ray passes through the surface an odd number of times.
 *
 * The octree is D. Meagher's (Geometric modeling using octree encoding, Computer Graphics and Image Processing 19,
 * 1982). Rays are tested as by S. Woop, C. Benthin and I. Wald (Watertight ray/triangle intersection, Journal of
 * Computer Graphics Techniques 2(1), 2013).
 *
 * @sa
 * vtkAssemblyActors vtkAssemblyReader
 */
#ifndef vtkAssemblyIndex_h
#define vtkAssemblyIndex_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the parts
#include <string> // for names

#ifndef VTK_UNBLOCKTHREADS // VTK 9.1: Python's other threads wait
#define VTK_UNBLOCKTHREADS
#endif

class vtkActor;
class vtkAssemblyActors;
class vtkIdList;
class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;
class vtkTable;

namespace vitrine
{
struct Ray;
}

class VTKVITRINERENDERING_EXPORT vtkAssemblyIndex : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkAssemblyIndex* New();
  vtkTypeMacro(vtkAssemblyIndex, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Kinds of clashes. See FindClashes().
   */
  enum ClashKind
  {
    INTERFERING = 0,
    TOUCHING = 1,
    NEAR_BY = 2
  };

  ///@{
  /**
   * Get/Set the memory for the triangles of parts and their octrees, in bytes, where 0 means no limit. If all need
   * more, they are written to a file in the folder for temporary files (TMPDIR or /tmp), which the system removes with
   * the index. Queries read them again, at most one more than the limit for each thread at once. Answers are the same.
   * About 75 bytes stand for a triangle. What stays in memory is a few hundred bytes for each part. The range is 0 to
   * VTK_TYPE_INT64_MAX, the default is 0. A value out of range is an error. So is a file that cannot be written, which
   * leaves the old limit.
   */
  void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  /**
   * Get why parts could not be written to the file of SetMemoryLimit(), or read again, when parts were added or asked
   * for last. The string is empty if they could. What was called has failed then, after an error.
   */
  std::string GetProblem();

  /**
   * Add a part, and return its number. Returns -1, after an error, if there is no geometry, or if it cannot be kept
   * within the memory limit.
   *
   * @param geometry  in model coordinates. Parts may share it.
   * @param place     the matrix from model to world coordinates. Null stands for the identity.
   * @param name      any text.
   */
  int AddPart(vtkPolyData* geometry, vtkMatrix4x4* place, const std::string& name);

  /**
   * Add all parts of an assembly. They get its numbers if there are none yet.
   */
  void AddAssembly(vtkAssemblyActors* actors);

  /**
   * Add what a renderer draws by polygons now: a part for each visible actor, and one for each visible block of
   * composite data. Actors and blocks that are hidden, without points or of other data are left out. Returns the number
   * of those. Caps of sections are no parts. Parts are whole also where a section cuts them. A null renderer is an
   * error.
   */
  int AddActors(vtkRenderer* renderer);

  /**
   * Get the number of parts.
   */
  int GetNumberOfParts() const;

  ///@{
  /**
   * Get a part's name, the number of its triangles, and whether it is closed. A number out of range is an error and
   * gives an empty text, 0 and false.
   */
  std::string GetPartName(int part);
  int GetPartNumberOfTriangles(int part);
  bool GetPartIsClosed(int part);
  ///@}

  ///@{
  /**
   * Get the actor that a part was added from, or that drew it for its assembly when it was added, and the flat index of
   * its block, which is 0 for a whole actor. They are null and 0 for other parts, and null for actors that are gone.
   */
  vtkActor* GetPartActor(int part);
  unsigned int GetPartBlock(int part);
  ///@}

  /**
   * Find all that a ray passes through, in order. The table gets the columns "part", "distance" from the origin,
   * "position" (3 components), "cell" of the part's geometry, and "entering": 1 where the ray goes into a closed part,
   * or through the front of an open one, and 0 where it comes out. Returns false, after an error, if a number is not
   * finite, the direction is 0, the length is negative or there is no table.
   *
   * @param direction  of any length.
   * @param length     how far the ray goes. It may be infinite.
   */
  bool CastRay(
    const double origin[3], const double direction[3], double length, vtkTable* crossings);

  /**
   * Find the stretches of a ray that are in closed parts, by the order of their beginnings. The table gets the columns
   * "part", "start" and "end", which are distances from the origin. Where the ray begins in a part, its start is 0.
   * Returns as CastRay() does.
   */
  bool FindWalls(const double origin[3], const double direction[3], double length, vtkTable* walls);

  /**
   * Find the part whose surface is nearest to a point, and its nearest point. Returns the part's number, or -1 if there
   * are no triangles or, after an error, if a number is not finite.
   */
  int FindNearest(const double point[3], double nearest[3]);

  ///@{
  /**
   * Find the parts whose surface shares a point with a box (xmin, xmax, ymin, ymax, zmin, zmax) or a sphere, or those
   * that lie in it wholly. Returns false, after an error, if a number is not finite, the box is empty, the radius is
   * negative or there is no list.
   */
  bool FindPartsInBox(const double bounds[6], bool isWholly, vtkIdList* parts);
  bool FindPartsInSphere(const double center[3], double radius, bool isWholly, vtkIdList* parts);
  ///@}

  /**
   * Get the least distance of the surfaces of two parts, and the points where they have it. It is 0 where the surfaces
   * meet. Returns -1, after an error, if a number is out of range or a part has no triangles.
   */
  double GetDistance(int first, int second, double onFirst[3], double onSecond[3]);

  /**
   * Get the tolerance that is usual for FindClashes(): a thousandth of the diagonal of the box around all parts, as
   * vtkAssemblyReader meshes STEP.
   */
  double GetDefaultTolerance();

  /**
   * Find the pairs of parts that clash:
   *
   * - INTERFERING: they are deeper in one another than the tolerance. The depth is how far a point of one part's
   *   surface in the other's solid is from the other's surface, at the deepest of many points: all corners, and more
   *   where the surfaces meet. The parts may be deeper in one another between these. Two equal parts at one place are
   *   as deep as points inside them. For two open parts, it is how far their triangles reach through one another.
   * - TOUCHING: not that, and the surfaces meet or are at most the tolerance apart.
   * - NEAR_BY: neither, and the surfaces are at most the clearance apart.
   *
   * The table gets the columns "first" and "second" (numbers of parts, the lower one first), "kind", "depth" (0 unless
   * interfering), "distance" of the surfaces, "position" (3 components) of the deepest point or the middle of the gap,
   * and "inside": the number of the part that lies wholly in the other's solid without meeting its surface, or -1.
   *
   * Invokes vtkCommand::ProgressEvent with the share that is done. Returns false if AbortExecute was set by then, when
   * the table has what was found so far, or, after an error, if a limit is negative or not finite, or there is no
   * table.
   */
  VTK_UNBLOCKTHREADS
  bool FindClashes(double clearance, double tolerance, vtkTable* clashes);

  ///@{
  /**
   * Set/Get whether FindClashes() stops soon. It begins with 0.
   */
  vtkSetMacro(AbortExecute, vtkTypeBool);
  vtkGetMacro(AbortExecute, vtkTypeBool);
  ///@}

  /**
   * Return false only if it is sure that two parts do not see each other: a surface of other parts lies between their
   * boxes, with no hole and no edge there.
   *
   * @param through  parts that do not block the view, as if of glass. It may be null.
   */
  bool MaySee(int first, int second, vtkIdList* through);

protected:
  vtkAssemblyIndex();
  ~vtkAssemblyIndex() override;

private:
  vtkAssemblyIndex(const vtkAssemblyIndex&) = delete;
  void operator=(const vtkAssemblyIndex&) = delete;

  struct Content;

  bool IsPart(int part);
  bool IsThere(const vtkObject* object);
  bool TakeRay(const double origin[3], const double direction[3], double length, vitrine::Ray& ray);
  template <class Ask>
  bool Answers(const Ask& ask);
  int AddPropsOf(vtkRenderer* renderer);
  int AddProp(vtkActor* actor, vtkMatrix4x4* place);

  vtkTypeInt64 MemoryLimit = 0;
  vtkTypeBool AbortExecute = 0;
  std::string Problem;
  std::unique_ptr<Content> Private;
};

#endif
