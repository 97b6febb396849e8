/**
 * What is drawn: parts, each of which becomes an actor of its own, what lights them, and where it is seen from.
 */
#ifndef VITRINE_SCENE_H
#define VITRINE_SCENE_H

#include "scene/Lights.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkAssemblyActors;
class vtkRenderer;

namespace program
{

/** One part. Geometry and material may be shared with other parts; nobody changes them. */
struct Part
{
  std::string Name;
  std::string
    Path; ///< names from the root of the file's tree, each after a slash; "/Name" where it is empty
  std::string MaterialName; ///< may be empty
  vtkSmartPointer<vtkPolyData> Geometry;
  vtkSmartPointer<vtkProperty> Material;
  vtkSmartPointer<vtkMatrix4x4> Transform; ///< to world coordinates; null for the identity
  vtkSmartPointer<vtkTexture> Texture;     ///< may be null
  vtkSmartPointer<vtkInformation> Keys;    ///< property keys for the actor; may be null
  vtkSmartPointer<vtkPlaneCollection> ClippingPlanes; ///< in world coordinates; may be null
  double SphereRadius = 0.0;     ///< above 0, each point is drawn as a sphere by a shader alone
  bool ForceTranslucent = false; ///< translucent, though VTK does not see it
  bool MayBeBlock =
    false; ///< may be drawn by one actor with other parts of its material; without radius and Texture
  bool IsOutlined = false;  ///< its outline is drawn through all that hides it
  bool IsXRayed = false;    ///< its opacity falls off, by Scene::XRayFalloff
  bool IsKeptWhole = false; ///< Scene::Sections do not cut it
  std::optional<int> Hatch; ///< of its caps, a vtkSection::HatchType; Scene::Hatch without
};

/** A part that is not drawn. */
struct SkippedPart
{
  std::string Name;
  std::string Reason;
};

/** A direction to look from, and how near. */
struct View
{
  double Azimuth = 0.0;   ///< degrees, counterclockwise around the scene's up axis; 0 is the front
  double Elevation = 0.0; ///< degrees above the horizon
  double Zoom = 1.0;      ///< 1 shows all of the scene
};

/** A place to look from, and what stands in the middle of the picture. */
struct CameraPlace
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
};

/** Where a scene stands in the world and how it likes to be seen. */
struct Stance
{
  std::array<double, 3> Up = { 0.0, 1.0, 0.0 };
  std::array<double, 3> Front = { 0.0, 0.0, 1.0 }; ///< from the scene to a viewer at azimuth 0
  View DefaultView;

  /**
   * Half the height of what a parallel projection shows; a perspective that fits the scene
   * without.
   */
  std::optional<double> ParallelScale;

  /**
   * The radius of a sphere around the scene's centre that fills the view's height; fits without.
   */
  std::optional<double> VisibleRadius;

  /** Where azimuth 0, elevation 0 and zoom 1 are seen from; chosen by bounds without. */
  std::optional<CameraPlace> Camera;

  /** Distances of what is seen, nearest and farthest; chosen by bounds without. */
  std::optional<std::array<double, 2>> ClippingRange;
};

/** What the colours of parts mean. */
struct ScalarBar
{
  std::string Title;
  vtkSmartPointer<vtkScalarsToColors> Colors; ///< null if there is no bar
};

struct Scene
{
  std::string Name;
  std::vector<Part> Parts;
  std::vector<Light> Lights; ///< none where VTK's headlight does
  std::vector<SkippedPart> Skipped;
  std::string LengthUnit; ///< of a file whose lengths were converted to metres; may be empty
  std::vector<std::string> Notes; ///< what was read otherwise than the file says
  std::string Expectation;        ///< of a generated scene: how methods do on it; may be empty
  Stance Placement;
  ScalarBar Bar;
  std::vector<std::array<double, 4>>
    Sections; ///< planes (x, y, z, d), which keep points p with p . (x, y, z) >= d
  std::optional<std::array<double, 6>>
    SectionBox;                ///< of which the inside is kept: xmin, xmax, ymin, ymax, zmin, zmax
  int Hatch = 0;               ///< of caps, a vtkSection::HatchType
  std::optional<int> CutEdges; ///< width of the lines around cuts in pixels; vtkSection's without
  double XRayFalloff = 0.0;    ///< power of the falloff of parts in an x-ray
};

/** The path of a part in the tree of its scene. Several parts may have it: PartPaths() tells them apart. */
std::string PathOf(const Part& part);

/** The paths of the scene's parts, with a number behind each that others before it have. Reports name parts by it. */
std::vector<std::string> PartPaths(const Scene& scene);

/** A name as a step of a path: after a slash, without slashes of its own. */
std::string PathStep(const std::string& name);

/** Bounds of a part in world coordinates: xmin, xmax, ymin, ymax, zmin, zmax. */
std::array<double, 6> PartBounds(const Part& part);

/** Bounds of all parts. The scene has at least one. */
std::array<double, 6> SceneBounds(const Scene& scene);

/** Triangles that the part's polygons and strips amount to. */
std::int64_t CountTriangles(vtkPolyData* geometry);

/** Whether scalars are colours, which are shown as they are. Other scalars are not. */
bool HasColors(vtkDataSetAttributes* data);

/** Whether the part is drawn as translucent geometry. */
bool IsTranslucent(const Part& part);

/**
 * Let parts be blocks where there are so many that actors of their own would take longer than all else. Blocks are
 * drawn in another order than parts, which shows where faces coincide.
 */
void DrawManyPartsAsBlocks(Scene& scene);

/** Have each part drawn by an actor of its own. */
void DrawPartsApart(Scene& scene);

/** A copy of a material that shares its textures. */
vtkSmartPointer<vtkProperty> CopyMaterial(vtkProperty* material);

/** Number of different materials. */
std::size_t CountMaterials(const Scene& scene);

/** Multiply `factor` into the opacity of every part. */
void MultiplyOpacity(Scene& scene, double factor);

/** Have the material of every part that is at least so opaque be wholly so. Textures and colours keep their alpha. */
void MakeOpaque(Scene& scene, double leastOpacity);

/**
 * Add the scene's parts to a renderer, each with an actor and a mapper of its own unless it may be a block. Textures
 * and properties are copied, since they hold objects of a window. Returns the actors: first those of parts that may be
 * no block, in the order of the parts.
 */
std::vector<vtkSmartPointer<vtkActor>> AddActors(const Scene& scene, vtkRenderer* renderer);

/** The same with the parts that may be blocks in `blocks`, which has none before, in the order of the parts. */
std::vector<vtkSmartPointer<vtkActor>> AddActors(
  const Scene& scene, vtkRenderer* renderer, vtkAssemblyActors* blocks);

/**
 * Have the planes and the box of the scene cut what the renderer draws, with caps. Without them nothing is cut. The
 * actors are those of AddActors().
 */
void CutSections(
  const Scene& scene, const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkRenderer* renderer);

/** Give the parts of the scene their outlines and x-ray looks. The actors are those of AddActors(). */
void ShowLooks(
  const Scene& scene, const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkRenderer* renderer);

}
#endif
