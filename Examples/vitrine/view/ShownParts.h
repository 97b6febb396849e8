/**
 * The parts of a scene in a renderer: found from what is drawn, and drawn otherwise than the scene says.
 */
#ifndef VITRINE_SHOWN_PARTS_H
#define VITRINE_SHOWN_PARTS_H

#include "scene/Scene.h"
#include "view/ViewState.h"

#include "vtkAssemblyActors.h"
#include "vtkNew.h"
#include "vtkPartLevels.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkProp;

namespace program
{

/** A part as Vitrine's classes take it. */
struct DrawnPart
{
  vtkActor* Actor = nullptr;
  unsigned int Block = 0; ///< flat index, 0 for an actor without blocks
};

class ShownParts
{
public:
  /** Add a scene's parts to a renderer. The scene stays as it is, and lives longer. */
  ShownParts(const Scene& scene, vtkRenderer* renderer);

  std::size_t Count() const { return this->Paths.size(); }
  const std::string& Path(std::size_t part) const { return this->Paths[part]; }
  DrawnPart Drawn(std::size_t part) const { return this->Parts[part]; }

  /** The part that an actor shows by a block. */
  std::optional<std::size_t> Find(vtkProp* prop, unsigned int block) const;

  /** The actors of AddActors(). */
  const std::vector<vtkSmartPointer<vtkActor>>& Actors() const { return this->Shown; }

  /**
   * Have parts drawn at levels of detail while the camera moves, so that no point moves by more than some pixels. Few
   * parts have actors of their own, which are drawn as they are.
   */
  void DrawByLevels(vtkRenderer* renderer, double pixels);

  /** The opacity that the scene gives a part. */
  double OwnOpacity(std::size_t part) const;

  /** Show parts so, and all others as the scene says. */
  void SetLooks(const std::map<std::size_t, PartLook>& looks);

  /** Move parts away from their places; see ExplodedOffsets(). */
  void Explode(double factor);

  /** The box around parts where they are shown now. */
  std::array<double, 6> Bounds(const std::set<std::size_t>& parts) const;

private:
  void SetLook(std::size_t part, const PartLook& look);

  const Scene& Content;
  vtkNew<vtkAssemblyActors> Blocks;
  vtkNew<vtkPartLevels> Levels;
  std::vector<vtkSmartPointer<vtkActor>> Shown;
  std::vector<std::string> Paths;
  std::vector<DrawnPart> Parts;
  std::vector<int> BlockNumbers; ///< of a part among Blocks, or -1
  std::map<std::pair<const vtkProp*, unsigned int>, std::size_t> Found;
  std::vector<vtkSmartPointer<vtkProperty>>
    OwnMaterials; ///< as the actors had them; null for blocks
  std::vector<std::array<double, 3>> Offsets;
  std::map<std::size_t, PartLook> Looks;
};

}
#endif
