/** Actors that draw the parts of an assembly at levels of detail, many parts in one. */
#ifndef VITRINE_ASSEMBLY_COARSE_ACTORS_H
#define VITRINE_ASSEMBLY_COARSE_ACTORS_H

#include "assembly/DrawnParts.h"
#include "assembly/PieceLevels.h"

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
 * of triangles, and points stay on the device.
 *
 * An actor of the assembly is *replaced* if levels may stand for all of its parts: these are drawn by triangles alone,
 * and it has no textures, and nothing else that assemblies do not give it: a place, clipping planes, shader code.
 */
class CoarseActors
{
public:
  using DetailOf = std::function<std::shared_ptr<const PartDetail>(vtkPolyData*)>;

  /** Makes the actors, of parts as they are drawn now. */
  CoarseActors(const DrawnParts& parts, const DetailOf& detailOf);

  /** Returns true if parts are drawn otherwise than when the actors were made. */
  bool AreOutdated(const DrawnParts& parts) const;

  /**
   * Chooses the coarsest levels with which no point moves by more than some pixels. Parts of the props that are to be
   * exact are left out, and drawn by those.
   */
  void Choose(LevelRequest asked);

  /** Returns true if a renderer has all actors that are replaced. */
  bool AreReplacedIn(vtkRenderer* renderer) const;

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

  /** What an actor of the assembly was when the actors were made. */
  struct ActorState
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkMTimeType Time; ///< of the actor itself, without what it has
    vtkMapper* Mapper;
    vtkMTimeType MapperTime; ///< of the mapper itself
    vtkSmartPointer<vtkDataObject> Data;
    vtkProperty* Property;
    bool IsVisible;
    bool IsPlain;
    bool IsReplaced = false;

    /** Returns true if the actor was certainly not set otherwise since. It is quick. */
    bool IsUntouched() const;
    void Show(bool isShown);

    bool operator==(const ActorState& other) const
    {
      return this->Property == other.Property && this->IsVisible == other.IsVisible &&
        this->IsPlain == other.IsPlain;
    }
  };
  static ActorState StateOf(vtkActor* actor);

  bool Fits(const LevelRequest& asked) const;
  static void Compose(Group& group);
  void Count(const LevelRequest& asked);

  std::vector<vtkSmartPointer<vtkActor>> Drawn;
  std::vector<Group> Groups;
  LevelCounts Chosen;
  double Reach = 0; ///< the greatest distance of points from the origin
  bool IsChosen = false;
  vtkMTimeType LooksTime = 0;
  std::vector<ActorState> States; ///< for each actor of the assembly
};

}

#endif
