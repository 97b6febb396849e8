/** Leaves out ghost cells, which are copies of cells that another rank draws. */
#ifndef VITRINE_TRANSPARENCY_RANKS_GHOST_CELLS_H
#define VITRINE_TRANSPARENCY_RANKS_GHOST_CELLS_H

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

class vtkActor;
class vtkProp;
class vtkRenderState;

namespace vitrine
{

/**
 * Stands actors without ghost cells in for those that have some, while a pass draws. VTK's mappers draw ghost cells.
 * The user's actors, mappers and data are left as they are.
 */
class GhostCells
{
public:
  GhostCells();
  ~GhostCells();
  GhostCells(GhostCells&&) noexcept;
  GhostCells& operator=(GhostCells&&) noexcept;

  /**
   * Returns the props of a frame, with stand-ins for translucent actors of a vtkPolyDataMapper whose data have cells
   * that are marked as duplicates. Data that have changed are cleaned again.
   */
  std::vector<vtkSmartPointer<vtkProp>> WithoutThem(const vtkRenderState* s);

  /** Returns which data of the last frame have ghost cells that cannot be left out, or an empty string. */
  const std::string& Problem() const { return this->WhyKept; }

private:
  struct StandIn;
  vtkProp* WithoutThem(vtkProp* prop);
  vtkProp* StandInOf(vtkActor* actor);

  std::map<vtkActor*, StandIn> StandIns; // of the last frame's actors with ghost cells
  std::map<vtkActor*, StandIn> Former;
  std::string WhyKept;
};

}
#endif
