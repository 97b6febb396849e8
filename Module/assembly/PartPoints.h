/**
 * Points of parts, whose bounds are found without threads.
 */
#ifndef vtkVitrinePartPoints_h
#define vtkVitrinePartPoints_h

#include "vtkPoints.h"

/**
 * Points in 32-bit float. VTK 9.1 asks the system for the number of processors, and wakes threads, for each array whose
 * range it computes. With 15,000 small parts this takes longer than reading their file.
 */
class PartPoints : public vtkPoints
{
public:
  static PartPoints* New();
  vtkTypeMacro(PartPoints, vtkPoints);

  void ComputeBounds() override;

protected:
  PartPoints() = default;
  ~PartPoints() override = default;

private:
  PartPoints(const PartPoints&) = delete;
  void operator=(const PartPoints&) = delete;
};

#endif
