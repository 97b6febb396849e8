/**
 * Ways to draw the parts of a scene: as actors, or below one.
 */
#ifndef VITRINE_PROGRAM_SCENE_FORM_H
#define VITRINE_PROGRAM_SCENE_FORM_H

#include "scene/Scene.h"

#include <map>
#include <string>

namespace program
{

enum class SceneForm
{
  Actors, ///< one for each part
  Blocks, ///< of one actor's composite data set
  Mesh    ///< of one actor, in which parts follow one another
};

/** As --as and JSON call them. */
const std::map<std::string, SceneForm>& NamesOfForms();

/** One opaque actor of all polygons of a scene, in the colours of their parts, as blocks or as a mesh. */
vtkSmartPointer<vtkActor> MakeActorOfAll(const Scene& scene, SceneForm form);

}

#endif
