/** Parts that are coloured by an array of their data. */
#ifndef VITRINE_COLOR_BY_H
#define VITRINE_COLOR_BY_H

#include "scene/Scene.h"

#include <string>

class vtkRenderer;

namespace program
{

/** For --help: what a text of ColorPartsBy() may be. */
std::string DescribeColorBy();

/**
 * Colour a scene's parts by an array at their points, or else at their cells. A text is ARRAY[,MIN:MAX][,MAP]. ARRAY is
 * a name, which takes the magnitudes of vectors, or NAME:N, which takes their component N from 0. The range is that of
 * the array's finite values over all parts, and the map is viridis, unless the text has others. Parts without the array
 * stay as they are. Scene::Bar tells the colours, and notes tell of parts and values that have none. Throws InputError
 * if no part has the array.
 */
void ColorPartsBy(const std::string& text, Scene& scene);

/** Add Scene::Bar, if there is one, to a renderer. */
void AddScalarBar(const Scene& scene, vtkRenderer* renderer);

}
#endif
