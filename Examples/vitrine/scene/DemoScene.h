/**
 * Generated scenes: demo:NAME[,key=value...]. The same text gives the same scene on every machine.
 */
#ifndef VITRINE_DEMO_SCENE_H
#define VITRINE_DEMO_SCENE_H

#include "scene/Scene.h"

#include <map>
#include <string>
#include <vector>

namespace program
{

/** True if `input` names a generated scene and no file. */
bool IsDemoScene(const std::string& input);

/**
 * Generate the scene. Throws InputError that lists what there is if the text names something else.
 */
Scene MakeDemoScene(const std::string& input);

/** How methods are expected to do on a generated scene; throws like MakeDemoScene(). */
std::string DemoExpectation(const std::string& input);

/** A few lines for each generated scene, for --help. */
std::string DescribeDemoScenes();

/** The values of a scene's keys, defaults filled in. */
using DemoValues = std::map<std::string, double>;

Scene MakeStackScene(const DemoValues& values);
Scene MakeSpheresScene(const DemoValues& values);
Scene MakeAssemblyScene(const DemoValues& values);
Scene MakeHallScene(const DemoValues& values);
Scene MakePaperMasksScene(const DemoValues& values);
Scene MakePaperListsScene(const DemoValues& values);

/** The most layers that the papers' scenes can be asked for. */
inline constexpr int MostPaperLayers = 64;

}
#endif
