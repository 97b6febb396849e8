/**
 * VTK's data objects as parts.
 */
#ifndef VITRINE_DATA_PARTS_H
#define VITRINE_DATA_PARTS_H

#include "scene/Scene.h"

#include "vtkDataObject.h"

#include <string>

namespace program
{

/**
 * A scene of what a file holds. A surface is a part. Any other data set is a part that shows its surface. The leaves of
 * a tree are parts whose paths are the names of its blocks; a collection's own hierarchy goes first. What is no data
 * set is listed in Scene::Skipped. Throws InputError if there is nothing, or if data are damaged so that VTK's filters
 * would crash.
 */
Scene MakeDataScene(const std::string& path, vtkDataObject* data);

}
#endif
