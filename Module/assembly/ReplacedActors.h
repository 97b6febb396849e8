/** Actors of an assembly that others stand for while levels are drawn. */
#ifndef VITRINE_ASSEMBLY_REPLACED_ACTORS_H
#define VITRINE_ASSEMBLY_REPLACED_ACTORS_H

#include "assembly/DrawnParts.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <unordered_set>
#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkMapper;
class vtkPolyData;
class vtkProp;
class vtkProperty;
class vtkRenderer;

namespace vitrine
{

/** Returns what blocks of an actor look like, or null if its mapper has no blocks. */
vtkCompositeDataDisplayAttributes* AttributesOf(vtkActor* actor);

/**
 * An actor is *replaced* if levels may stand for all of its parts: these are drawn by triangles alone, and it has no
 * textures, and nothing else that assemblies do not give it: a place, clipping planes, shader code.
 */
class ReplacedActors
{
public:
  /** Notes what the actors are now. */
  ReplacedActors(const DrawnParts& parts, const std::function<bool(vtkPolyData*)>& hasLevels);

  bool Has(vtkActor* actor) const { return this->Actors.count(actor) > 0; }

  /** Returns true if a renderer has all. */
  bool AreIn(vtkRenderer* renderer) const;

  /** Returns true if parts are drawn otherwise than they were. */
  bool AreOutdated(const DrawnParts& parts) const;

  /** Hides all but those that are exact, and adds them to `hidden`, or shows those again. */
  void Hide(const std::unordered_set<vtkProp*>& exact, std::unordered_set<vtkProp*>& hidden);
  void Show(const std::unordered_set<vtkProp*>& hidden);

private:
  /** What an actor of the assembly was. */
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

    /** Returns true if the actor was certainly not set otherwise since. It is quick. */
    bool IsUntouched() const;
    void SetVisible(bool isVisible);

    bool operator==(const ActorState& other) const
    {
      return this->Property == other.Property && this->IsVisible == other.IsVisible &&
        this->IsPlain == other.IsPlain;
    }
  };
  static ActorState StateOf(vtkActor* actor);

  std::vector<ActorState> States; ///< for each actor of the assembly
  std::unordered_set<vtkProp*> Actors;
  vtkMTimeType LooksTime = 0;
};

}

#endif
