/**
 * What the window says: a line below, a list of layers above, and the keys.
 */
#ifndef VITRINE_VIEW_TEXTS_H
#define VITRINE_VIEW_TEXTS_H

#include "view/LayerList.h"

#include "vtkNew.h"
#include "vtkTextActor.h"

#include <set>
#include <string>

class vtkRenderer;

namespace program
{

class ViewTexts
{
public:
  explicit ViewTexts(vtkRenderer* renderer);

  void SetLine(const std::string& line);

  /** List the parts under the cursor, from front to back, and mark those selected. No list if there are none. */
  void SetLayers(const std::vector<PartUnderCursor>& layers, const ShownParts& parts,
    const std::set<std::size_t>& selected);

  /** Show the keys in place of the layers, or no keys if the text is empty. */
  void SetKeys(const std::string& keys);

  bool HasKeys() const { return this->Keys->GetVisibility() != 0; }

  void SetVisible(bool isVisible);

private:
  vtkRenderer* Renderer;
  vtkNew<vtkTextActor> Line;
  vtkNew<vtkTextActor> Layers;
  vtkNew<vtkTextActor> Keys;
};

}
#endif
