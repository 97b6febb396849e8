/**
 * From where a scene is seen.
 */
#ifndef VITRINE_VIEWPOINT_H
#define VITRINE_VIEWPOINT_H

#include "scene/Scene.h"

#include "vtkCamera.h"
#include "vtkSmartPointer.h"

namespace program
{

/**
 * A camera that looks at the middle of the scene from the direction of `view` and, at zoom 1, shows
 * all of it in a picture of width / height = `aspect`.
 */
vtkSmartPointer<vtkCamera> PlaceCamera(const Scene& scene, const View& view, double aspect);

/**
 * Make everything appear `factor` times as large in the picture. vtkCamera::Zoom divides the angle of view instead, and
 * shows nothing for angles beyond 180 degrees.
 */
void Magnify(vtkCamera* camera, double factor);

/**
 * The same camera after moving so many pixels to the right and upwards, which are those of a picture of that height, in
 * the plane through the focal point.
 */
vtkSmartPointer<vtkCamera> Shift(vtkCamera* camera, double right, double up, int height);

/** The same camera after going `degrees` around the scene's up axis. */
vtkSmartPointer<vtkCamera> Orbit(vtkCamera* camera, double degrees);

}
#endif
