#ifndef VITRINE_CULLING_SCENE_PARTS_H
#define VITRINE_CULLING_SCENE_PARTS_H

#include "Core/culling/walk/LooseOctree.h"
#include "Core/culling/walk/PartCuller.h"
#include "culling/BlendedProps.h"
#include "culling/PartGeometry.h"
#include "culling/mappers/DividedMapper.h"
#include "scene/PipelineState.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkDataSet;
class vtkDataSetMapper;
class vtkMapper;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProp;
class vtkShaderProperty;
class vtkTrivialProducer;

namespace vitrine
{

class BlockParts;
class RendererView;
struct CullingDecision;
struct PropFacts;

/**
 * The actors of a renderer as parts that hide others and are hidden. It keeps the boxes of the parts in an octree, and
 * updates them from frame to frame by modification times. An actor whose mapper draws parts one by one
 * (DividedMapper.h) is as many parts, and one more that has no place.
 */
class SceneParts : public OccluderSource
{
public:
  /** Why a part is drawn, as one byte per part. 0 means that it is left out. */
  enum Showing : std::uint8_t
  {
    IsLeftOut = 0,
    MayShow = 1,     ///< It is in the view, and was not found hidden.
    MayShineThrough, ///< It was found hidden, but lies behind a blended prop.
    MayBeElsewhere,  ///< It was found hidden, but a device may draw it beside its place.
    FirstKept ///< VTK needs it: the value for the first row of KeepRows(). Values of other rows follow.
  };

  /**
   * Updates everything for the props that are about to be drawn. Updates the pipelines of mappers, as drawing does.
   * @return  false if drawing makes images of textures; then nothing is known of what it draws
   */
  bool Update(vtkProp* const* props, int count);

  /**
   * Forgets what is known of props that are deleted. What is known of props that are not drawn for a while is kept, as
   * they may come again.
   */
  void ForgetRemoved();

  /** Returns the origin of all boxes and occluders, in world coordinates (WC). */
  const glm::dvec3& Origin() const { return this->Middle; }

  /** Returns the octree of the boxes of all parts that others may hide. */
  const LooseOctree& Tree() const { return this->Boxes; }

  /** Sets a byte per part: 1 if it was in the last update, else 0. */
  void MarkDrawn(std::vector<std::uint8_t>& visible) const;

  /** Returns the number of parts of the i-th prop of the last update. It is at least 1. */
  int CountParts(int i) const;

  /** Returns the number of these parts that do not show. */
  int CountHidden(int i, const std::vector<std::uint8_t>& visible) const;

  /**
   * Tells the mapper of the i-th prop which of its parts show.
   * @return  what the mapper was told, which holds as long as the caller keeps it; null if the prop is drawn as a whole
   */
  std::shared_ptr<const ShownParts> TellMapper(vtkRenderer* renderer, const ViewMatrices& view,
    int i, const std::vector<std::uint8_t>& visible) const;

  /** The greatest values of some quantities over many parts. */
  struct Extremes
  {
    glm::dvec3 Reach{ 0.0 }; ///< sums of absolute values that lead to coordinates from Origin()
    float Growth = 0.0f;     ///< pixels by which lines and points are drawn wider than they are
  };

  /** Returns the extremes of the parts that others may hide, and of the parts that only the view hides. */
  const Extremes& OfHideable() const { return this->ExtremesOfHideable; }
  const Extremes& OfViewAlone() const { return this->ExtremesOfViewAlone; }

  /** Returns the number of parts that only the view hides. */
  std::size_t CountOfViewAlone() const { return this->ViewAlone.size(); }

  /** Sets the bytes of these parts to 0 if they lie outside of the view. */
  void CullOutside(const ScreenProjection& view, std::vector<std::uint8_t>& visible) const;

  /**
   * Lets parts show that were found hidden at their place, but not wherever a device may draw them. A device draws
   * faces beside their place, and faces that are seen from their edge at any depth. All wireframes in the view show,
   * too: a line that is seen nearly from its end is drawn beyond it, at any depth.
   * @param culler   the culler that found the parts hidden
   * @param drawn    one byte per part, 1 if this frame draws it
   * @param visible  one byte per part; becomes MayBeElsewhere for such parts
   */
  void VerifyHidden(PartCuller& culler, const ScreenProjection& view,
    const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible);

  /**
   * Returns true if a prop is blended in the opaque pass at a place that is not known. Then all parts in the view may
   * show.
   */
  bool BlendsAnywhere() const;

  /** Returns true if a prop is blended in the opaque pass. */
  bool BlendsSomewhere() const;

  /**
   * Returns the class of such a prop, and the reason. Of several props, it is one that lets most of the screen be
   * drawn. There must be one.
   */
  std::string DescribeBlended() const;

  /**
   * Lets parts show that were found hidden, but overlap a prop on the screen that is blended in the opaque pass. They
   * may shine through.
   * @param drawn    one byte per part, 1 if this frame draws it
   * @param visible  one byte per part; becomes MayShineThrough for such parts
   */
  void ShowBehindBlended(const SampleGrid& samples, const ScreenProjection& view,
    const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible) const;

  /** Returns true if there are props that are always drawn. They may draw more if any prop is translucent. */
  bool HasOthersThanParts() const;

  /** Lets all blocks of a prop show that is drawn as a whole, if any of them does. */
  void ShowWhole(std::vector<std::uint8_t>& visible) const;

  /**
   * Lets one translucent prop show, if there are any and all of them would be left out.
   * @param visible  one byte per part; becomes `reason` for the parts of that prop
   */
  void KeepOneTranslucent(std::vector<std::uint8_t>& visible, std::uint8_t reason) const;

  /** Lets one prop of any kind show, if all would be left out. */
  void KeepOne(std::vector<std::uint8_t>& visible, std::uint8_t reason) const;

  /** The data of a frame by which Explain() finds what became of a prop. */
  struct Fate
  {
    const RendererView& View;
    const std::vector<std::uint8_t>& Visible; ///< as Showing, at the end of the frame
    const CullingDecision& Decision;
  };

  /** Returns in words why a prop was drawn in the frame of the last update, or that it was not. */
  std::string Explain(vtkProp* prop, const Fate& fate) const;

  Occluder OccluderOf(std::uint32_t part) override;
  void PrefetchOccluder(std::uint32_t part) const override;

private:
  /**
   * What was known of a prop, or of a piece of one, when it was last looked at. The objects behind pointers exist as
   * long as the times of their holders have not changed.
   */
  struct alignas(64) Part // the members that are read in each frame fill two cache lines
  {
    vtkMTimeType PropTime = 0;
    vtkActor* Actor = nullptr; ///< null if it cannot be hidden
    vtkShaderProperty* Shader = nullptr;
    vtkMTimeType ShaderTime = 0;
    vtkPolyDataMapper* Mapper = nullptr; ///< the mapper that draws (DrawingMapper.h)
    vtkMTimeType MapperTime = 0;
    /** The producer of the data. Null if filters make them (Pipeline). */
    vtkTrivialProducer* Producer = nullptr;
    vtkMTimeType ProducerTime = 0;
    vtkPolyData* Data = nullptr;
    vtkMTimeType DataTime = 0;
    std::shared_ptr<PartGeometry> Geometry;
    DividedMapper* Divided = nullptr;            ///< what divides it into parts
    std::shared_ptr<const MapperParts> Division; ///< null if it is one part
    bool HasTextures = false;
    bool IsOpaque = false; ///< textures aside
    bool MayHide = false;
    bool HasBackFaces = true;   ///< back faces are drawn
    bool IsOfViewAlone = false; ///< only the view hides it
    bool HasSurfaceMapper = false;
    bool HasSelection = false; ///< its mapper draws a selection
    bool HasLevels = false;    ///< the actor may take another mapper, and no time tells of it
    vtkMapper* OfActor = nullptr;
    bool IsWireframe = false;
    /** From model coordinates (MC) to world coordinates (WC) relative to Origin(). */
    glm::dmat4 ToWorld{ 1.0 };
    glm::dmat4 FromWorld{ 1.0 };
    glm::dvec3 Sums{ 0.0 }; ///< sums of absolute values that lead to world coordinates
    DeviceCoordinates Drawn;
    float Growth = 0.0f;
    std::vector<std::uint32_t> Pieces; ///< the parts of the division
    Box InView;                        ///< its box, if only the view hides it
    /** The mapper that uses Mapper to draw, if there is one. */
    vtkDataSetMapper* SurfaceMapper = nullptr;
    vtkMTimeType SurfaceMapperTime = 0;
    /** The input of SurfaceMapper, if its own filter makes a surface of it. */
    vtkDataSet* Input = nullptr;
    vtkMTimeType InputTime = 0;
    vtkAlgorithm* Filter = nullptr;
    vtkMTimeType FilterTime = 0;
    PipelineState Pipeline;
    /** The blocks of VTK's own composite mapper, which draws all of them or none. Null for other mappers. */
    std::shared_ptr<BlockParts> Blocks;
    /** The rule by which it is always drawn. Null if it may be left out. */
    const PropRow* AlwaysDrawnBy = nullptr;
    const PropRow* ViewAloneBy = nullptr; ///< the rule for IsOfViewAlone; null if that is false
    /** A rule by which it hides nothing in any frame; null if there is none. */
    const PropRow* HidesNothingBy = nullptr;
  };

  /** Settings of VTK of which no time of a part tells. */
  struct ProgramSettings
  {
    int Coincident = 0; ///< VTK_RESOLVE_OFF and so on
    double Factor = 0.0;
    double Units = 0.0; ///< of the offset of polygons
    bool IsShifted = false;
  };

  class Shapes;

  PropFacts FactsOf(const Part& part) const;
  std::string ExplainShown(vtkProp* prop, std::uint32_t part, const Fate& fate) const;
  const PropRow* FindHidesNothing(const Part& part) const;
  bool IsOutside(std::uint32_t part, const RendererView& view) const;
  bool IsOpaque(const Part& part) const;
  bool Shows(std::size_t i, const std::vector<std::uint8_t>& visible) const;
  bool MayBeTranslucent(std::uint32_t part) const;
  void Mark(
    std::uint32_t part, std::vector<std::uint8_t>& visible, std::uint8_t value = MayShow) const;
  bool IsDrawnApart(const Part& part, const SampleGrid& samples) const;
  Occluder ShapeOf(std::uint32_t part);
  bool MayShowAnywhere(const BoxedPart& part, const ScreenProjection& view) const;
  std::vector<BoxedPart> FindHiddenInView(const ScreenProjection& view, const SampleGrid& samples,
    const std::vector<std::uint8_t>& drawn, const std::vector<std::uint8_t>& visible) const;
  bool LookAtAll(vtkProp* const* props, int count, std::vector<std::uint32_t>& moved);
  void LookAtOpacity(std::uint32_t part);
  void MakeData(Part& part);
  void LookAnewIfSettingsChanged();
  void ForgetAbsent();
  void ForgetPart(std::uint32_t part, std::vector<std::uint32_t>& moved);
  void FindAll(vtkProp* const* props, int count);
  std::uint32_t Find(vtkProp* prop);
  std::uint32_t AddPart(vtkProp* prop);
  void FindUnchanged();
  bool AreImagesMade() const;
  void PrefetchObjects(std::uint32_t i) const;
  bool IsPlain(std::uint32_t i) const;
  bool HasPipeline(std::uint32_t i) const;
  bool IsUnchanged(std::uint32_t i) const;
  static bool AreDataMadeAlready(const Part& part);
  void Look(std::uint32_t i);
  void LookAtMapper(Part& part);
  static DividedMapper* DividerOf(Part& part);
  void LookAtData(Part& part, const PartGeometry* before);
  void ReadActor(Part& part);
  static DeviceCoordinates CoordinatesOf(const Part& part);
  Box Read(Part& part, const DeviceCoordinates& drawn) const;
  const Box& BoxInWorld(std::size_t part) const;
  void Place(std::uint32_t part, const Box& box, std::vector<std::uint32_t>& moved);
  void PlaceWhole(std::uint32_t whole, std::vector<std::uint32_t>& moved);
  void FitPieces(std::uint32_t whole, std::vector<std::uint32_t>& moved);
  std::shared_ptr<PartGeometry> GeometryOf(vtkPolyData* data, const PartGeometry* before);
  void ForgetDeadGeometries();
  void Replant(const std::vector<std::uint32_t>& moved);
  void MeasureAll();
  bool IsFarOff(glm::dvec3& middle) const;
  void MoveOrigin(const glm::dvec3& middle);

  std::vector<Part> Parts;
  std::vector<vtkProp*> PropOf;                ///< the prop of each part; null for pieces
  std::vector<vtkWeakPointer<vtkProp>> Living; ///< the same; null after it is deleted
  std::vector<vtkMTimeType> SeenIn;            ///< for each part the last update that had it
  std::vector<Box> BoxOf;
  std::vector<std::uint8_t> HasPieces; ///< 1 for each part that has pieces
  std::vector<Blending> Blends;        ///< for each part that is a prop
  std::vector<std::uint32_t> Drawn; ///< the parts of props of this frame, in the order of the props
  std::vector<std::uint8_t> AreSame; ///< 1 for each of these that surely is unchanged
  std::vector<std::uint32_t> Spare;  ///< parts that belong to no prop
  std::unordered_map<vtkProp*, std::uint32_t> Index;
  std::unordered_map<vtkPolyData*, std::weak_ptr<PartGeometry>> Geometries;
  /** Geometries that ForgetAbsent() keeps until their parts are found again. */
  std::vector<std::shared_ptr<PartGeometry>> Kept;
  std::uint32_t Cursor = 0; ///< the part after the last one that was found
  /** For each actor of this frame, true if its textures are opaque. */
  std::unordered_map<vtkActor*, bool> AreOpaque;
  vtkMTimeType Frame = 0;       ///< number of updates
  vtkMTimeType Looks = 0;       ///< the number of times that all parts were looked at
  bool HasMadeData = false;     ///< a filter has made data since all parts were last looked at
  bool HasImagesToMake = false; ///< drawing has images of textures to make
  LooseOctree Boxes;
  ProgramSettings Settings; ///< settings of the whole program at the last update
  glm::dvec3 Middle{ 0.0 };
  Extremes ExtremesOfHideable;
  Extremes ExtremesOfViewAlone;
  std::vector<BoxedPart> ViewAlone; ///< parts that only the view hides
};

}

#endif
