/**
 * The rules of the culler for props, as a table: which hide nothing, which only the view hides, which are always drawn,
 * and why. SceneParts asks them as it reads props.
 *
 * The rules for frames stand in CullingPolicy.h.
 */
#ifndef VITRINE_CULLING_PROP_POLICY_H
#define VITRINE_CULLING_PROP_POLICY_H

#include "vtkType.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyDataMapper;
class vtkProp;

namespace vitrine
{

class PartGeometry;
struct MapperPart;
struct MapperParts;

/** What a rule does. Props of all rules hide nothing. */
enum class PropEffect
{
  AlwaysDrawn,
  ViewAlone,     ///< It is left out where it lies outside of the view, and nowhere else.
  HidesNothing,  ///< It may be hidden.
  Blends,        ///< What lies behind it is drawn, since it may shine through.
  BlendsAnywhere ///< All in the view is drawn, since it may shine through.
};

/** What the effect is, as a clause: "it is always drawn". */
const char* EffectOf(PropEffect effect);

/** When a rule is asked: as soon as what it looks at is known of a prop. No rule of an earlier stage applies then. */
enum class PropStage
{
  Class,    ///< by the prop alone
  Mapper,   ///< by the mapper that draws
  Depths,   ///< by the mapper that draws, too
  Division, ///< by the parts that its mapper draws one by one
  Data,     ///< by the data
  Place,    ///< by points and matrix, of each part
  Distance, ///< by sums of coordinates, of each part
  Opacity,  ///< by settings of an actor
  Surface,  ///< by settings of an actor
  Part,     ///< by a part that its mapper draws
  Hidden,   ///< of what was found hidden
  Frame,    ///< in each frame in which it could hide anything
  Blending, ///< of a prop that VTK draws among what is opaque
  Beside,   ///< of one that is blended
  Count
};

/** What is known of a prop. What a stage does not look at may be null. */
struct PropFacts
{
  vtkProp* Prop = nullptr;
  vtkActor* Actor =
    nullptr; ///< null as well if it blends otherwise than by its mapper, as texts do
  vtkPolyDataMapper* Mapper = nullptr; ///< that draws (scene/DrawingMapper.h)
  const MapperParts* Division = nullptr;
  const MapperPart* Piece = nullptr;
  PartGeometry* Geometry = nullptr;
  bool AreTexturesOpaque = true;
  const glm::dmat4* ToWorld = nullptr; ///< from the data's coordinates
  const glm::dvec3* Sums = nullptr;    ///< of absolute values that lead to world coordinates
  vtkMTimeType Frame = 0;              ///< as PartGeometry counts them
};

/** A rule for props. */
struct PropRow
{
  PropStage Stage;
  PropEffect Effect;
  const char* Condition; ///< where it applies, as a clause
  const char* Why;       ///< as a clause
  std::function<bool(const PropFacts&)> Applies;
  std::string (*Detail)(vtkProp*) = nullptr; ///< what it is that applies, as a class
};

/** All rules for props. */
const std::vector<PropRow>& PropRows();

/** Stands for no rule where one is told by its number. */
constexpr std::uint8_t NoPropRow = 255;

/** The rule's place in PropRows(); NoPropRow of null. */
std::uint8_t NumberOf(const PropRow* row);

/** The first rule of a stage that applies; null if none does. */
const PropRow* FindPropRow(PropStage stage, const PropFacts& facts);

/** The rule in words, of a prop: "its class is not known (vtkVolume): where it is drawn is not known". */
std::string Explain(const PropRow& row, vtkProp* prop);

}

#endif
