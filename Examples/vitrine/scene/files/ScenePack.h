/**
 * Scenes handed over to other programs, such as Vitrine's Python package.
 */
#ifndef VITRINE_SCENE_PACK_H
#define VITRINE_SCENE_PACK_H

#include "scene/Scene.h"

#include <string>

namespace program
{

/**
 * Write a scene into a folder that is there: blocks.vtk and parts.json.
 *
 * blocks.vtk is a vtkMultiBlockDataSet in VTK's legacy format: the different geometries, and then the images of
 * textures. parts.json names the blocks of each part by their numbers, its place and its material, and has the notes.
 * Lights, sections and the view are not kept. Throws InputError if a part is drawn by more than that.
 */
void WriteScenePack(const Scene& scene, const std::string& folder);

}
#endif
