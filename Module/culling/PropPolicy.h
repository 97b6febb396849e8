/**
 * The rules of the culler for props, as a table: which props hide nothing, which only the view hides, which are always
 * drawn, and why. SceneParts asks them as it reads props.
 *
 * The rules for frames are in CullingPolicy.h.
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
class vtkMapper;
class vtkPolyDataMapper;
class vtkProp;

namespace vitrine
{

class PartGeometry;
struct MapperPart;
struct MapperParts;

/** The effect of a rule. A prop to which any rule applies hides nothing. */
enum class PropEffect
{
  AlwaysDrawn,
  ViewAlone,     ///< It is left out only if it lies outside of the view.
  HidesNothing,  ///< It hides nothing, but may be hidden.
  Blends,        ///< Parts behind it are drawn, since they may shine through.
  BlendsAnywhere ///< All parts in the view are drawn, since they may shine through.
};

/** Returns the effect as a clause, as "it is always drawn, and hides nothing". */
const char* EffectOf(PropEffect effect);

/** When a rule is asked: as soon as the facts that it looks at are known. No rule of an earlier stage applies then. */
enum class PropStage
{
  Class,    ///< needs the prop alone
  Mapper,   ///< needs the mapper that draws
  Depths,   ///< needs the mapper that draws; about depths
  Division, ///< needs the parts that the mapper draws one by one
  Data,     ///< needs the data
  Place,    ///< needs points and matrix of a part
  Distance, ///< needs PropFacts::Sums of a part
  Opacity,  ///< needs settings of an actor: what lets light through
  Surface,  ///< needs settings of an actor: how its surface is drawn
  Part,     ///< needs a part that the mapper draws
  Hidden,   ///< for a part that was found hidden; asked for reasons alone (README.md)
  Frame,    ///< for a part that could hide others in a frame; asked for reasons alone (README.md)
  Blending, ///< for a prop that VTK draws in its opaque pass
  Beside,   ///< for a prop that is blended: where it may draw
  Count
};

/** The facts that the rules for props look at. Facts that a stage does not need may be null. */
struct PropFacts
{
  vtkProp* Prop = nullptr;
  /** Null, too, for a prop that is blended by other means than its mapper, as texts are. */
  vtkActor* Actor = nullptr;
  vtkPolyDataMapper* Mapper = nullptr; ///< the mapper that draws (scene/DrawingMapper.h)
  const MapperParts* Division = nullptr;
  const MapperPart* Piece = nullptr;
  PartGeometry* Geometry = nullptr;
  bool AreTexturesOpaque = true;
  const glm::dmat4* ToWorld = nullptr; ///< from model (MC) to world coordinates (WC)
  const glm::dvec3* Sums = nullptr;    ///< sums of absolute values that lead to world coordinates
  vtkMTimeType Frame = 0;              ///< the frame that PartGeometry gets
};

/** A rule for props. */
struct PropRow
{
  PropStage Stage;
  PropEffect Effect;
  const char* Condition; ///< where the rule applies, as a clause
  const char* Why;       ///< the reason, as a clause
  std::function<bool(const PropFacts&)> Applies;
  std::string (*Detail)(vtkProp*) = nullptr; ///< returns the name of the class that the rule found
};

/** Returns all rules for props. */
const std::vector<PropRow>& PropRows();

/** The index that stands for no rule. */
constexpr std::uint8_t NoPropRow = 255;

/** Returns the index of a rule in PropRows(), or NoPropRow for null. */
std::uint8_t NumberOf(const PropRow* row);

/** Returns the first rule of a stage that applies, or null. */
const PropRow* FindPropRow(PropStage stage, const PropFacts& facts);

/** Returns true if a mapper has a selection to draw. It may be empty, as ParaView's is. */
bool DrawsSelection(vtkMapper* mapper);

/** Returns the rule in words, for a prop: "its class is not known (vtkVolume): where it is drawn is not known". */
std::string Explain(const PropRow& row, vtkProp* prop);

}

#endif
