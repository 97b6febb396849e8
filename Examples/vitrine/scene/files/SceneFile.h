/**
 * Scenes from files.
 */
#ifndef VITRINE_SCENE_FILE_H
#define VITRINE_SCENE_FILE_H

#include "scene/Scene.h"
#include "scene/files/ReadingOptions.h"

#include <string>

namespace program
{

/**
 * Read a file of a kind that ListFileTypes() names. Throws InputError, with one line that
 * says what is wrong, if the file cannot be read as a whole or has nothing to draw. Parts without
 * anything to draw are listed in Scene::Skipped.
 */
Scene ReadSceneFile(const std::string& path, const ReadingOptions& options = {});

/** ".glb, .gltf, ..." */
std::string ListFileTypes();

}
#endif
