/** Actors that draw the parts of an assembly at levels of detail, many parts in one. */
#ifndef VITRINE_ASSEMBLY_COARSE_ACTORS_H
#define VITRINE_ASSEMBLY_COARSE_ACTORS_H

#include "assembly/DrawnParts.h"
#include "assembly/PieceLevels.h"
#include "assembly/ReplacedActors.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <unordered_set>
#include <vector>

namespace vitrine
{

/** What was drawn. */
struct LevelCounts
{
  std::size_t Triangles = 0;
  std::size_t WholeTriangles = 0;
  double GreatestPixels = 0; ///< no point is farther from where it should be, in pixels
};

/**
 * The parts of a look are one actor, whose points are those of all of them. So another choice of levels is another list
 * of triangles, and points stay on the device. */
class CoarseActors
{
public:
  using DetailOf = std::function<std::shared_ptr<const PartDetail>(vtkPolyData*)>;

  /** Makes the actors, of parts as they are drawn now. */
  CoarseActors(const DrawnParts& parts, const DetailOf& detailOf);

  /** Returns true if parts are drawn otherwise than when the actors were made. */
  bool AreOutdated(const DrawnParts& parts) const { return this->Replaced.AreOutdated(parts); }

  /**
   * Chooses the coarsest levels with which no point moves by more than some pixels. Parts of the props that are to be
   * exact are left out, and drawn by those.
   */
  void Choose(LevelRequest asked);

  /** Returns true if a renderer has all actors that are replaced. */
  bool AreReplacedIn(vtkRenderer* renderer) const { return this->Replaced.AreIn(renderer); }

  /**
   * Shows the actors in place of those that they replace, but for some that are exact.
   * @param standIns  who stands for whom, which is added to
   */
  void BeginFrame(const std::unordered_set<vtkProp*>& exact, StandIns& standIns);
  void EndFrame(const StandIns& standIns);

  const std::vector<vtkSmartPointer<vtkActor>>& Actors() const { return this->Drawn; }
  const LevelCounts& Counts() const { return this->Chosen; }

private:
  struct Group
  {
    vtkSmartPointer<vtkPolyData> Data;
    std::vector<Piece> Pieces;
  };

  class Builder;

  bool Fits(const LevelRequest& asked) const;
  static void Compose(Group& group);
  void Count(const LevelRequest& asked);

  ReplacedActors Replaced;
  std::vector<vtkSmartPointer<vtkActor>> Drawn;
  std::vector<Group> Groups;
  LevelCounts Chosen;
  double Reach = 0; ///< the greatest distance of points from the origin
  bool IsChosen = false;
};

}

#endif
