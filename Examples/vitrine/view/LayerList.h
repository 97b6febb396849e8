/**
 * The layers under a click, and the part that it stands for.
 */
#ifndef VITRINE_LAYER_LIST_H
#define VITRINE_LAYER_LIST_H

#include "view/ShownParts.h"

#include "vtkLayerPicker.h"
#include "vtkNew.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** A part that a pixel shows. */
struct PartUnderCursor
{
  std::size_t Part;
  double Share;                   ///< of the picture, of all of its layers
  double Opacity;                 ///< of its first layer
  std::array<double, 3> Position; ///< of its first layer, in world coordinates
};

class LayerList
{
public:
  explicit LayerList(vtkRenderer* renderer);

  /**
   * Find what a pixel of the last frame shows. Returns the part that the eye sees there: the first one with half of the
   * picture, or else the one with most. `deeper` gives the one behind, and so does the same pixel again. Null if there
   * is none. Throws RuntimeError if the driver cannot tell layers.
   */
  const PartUnderCursor* Click(int x, int y, bool deeper, const ShownParts& parts);

  /** From front to back. */
  const std::vector<PartUnderCursor>& Parts() const { return this->Found; }

  void Forget();

private:
  void Find(int x, int y, const ShownParts& parts);
  std::size_t SeenByEye() const;

  vtkNew<vtkLayerPicker> Picker;
  std::vector<PartUnderCursor> Found;
  std::array<int, 2> Pixel{ -1, -1 };
  std::size_t Chosen = 0;
};

}
#endif
