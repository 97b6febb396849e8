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

class RendererView;
struct CullingDecision;
struct PropFacts;

/**
 * The actors of a renderer as parts that hide and are hidden: their boxes in an octree, kept up to date from frame to frame by
 * the times at which they were modified. An actor whose mapper draws parts one by one (DividedMapper.h) is as many parts, and one
 * that has no place.
 */
class SceneParts : public OccluderSource
{
public:
  /** Why a part is drawn, as a byte of each part. */
  enum Showing : std::uint8_t
  {
    IsLeftOut = 0,
    MayShow = 1,     ///< It is in the view, and was not found hidden.
    MayShineThrough, ///< It was, but lies behind something that is blended.
    MayBeElsewhere,  ///< It was, but a device may draw it beside its place.
    FirstKept        ///< Others need it: this and the row of KeepRows().
  };

  /**
   * Brings everything up to date with what is about to be drawn. Updates the mappers' pipelines, as drawing does.
   * @return  false where drawing makes images of textures, so that nothing is known of what it draws
   */
  bool Update(vtkProp* const* props, int count);

  /** Lets go of what is known of props that are gone. Of those that are not drawn for a while it is kept, as they may come again. */
  void ForgetRemoved();

  /** Where boxes and occluders count from, in world coordinates (WC). */
  const glm::dvec3& Origin() const { return this->Middle; }

  /** Of all boxes of what others may hide. */
  const LooseOctree& Tree() const { return this->Boxes; }

  /** Puts 1 for the parts that were in the last update, 0 for others. */
  void MarkDrawn(std::vector<std::uint8_t>& visible) const;

  /** How many parts the i-th prop of the last update has: at least one. */
  int CountParts(int i) const;

  /** How many of them do not show. */
  int CountHidden(int i, const std::vector<std::uint8_t>& visible) const;

  /**
   * Tells the mapper of that prop which of its parts show.
   * @return  what it is told, for as long as this is held; null if it draws all it has
   */
  std::shared_ptr<const ShownParts> TellMapper(vtkRenderer* renderer, const ViewMatrices& view,
    int i, const std::vector<std::uint8_t>& visible) const;

  /** What many parts have of something at most. */
  struct Extremes
  {
    glm::dvec3 Reach{ 0.0 }; ///< sums of absolute values that lead to coordinates from the origin
    float Growth = 0.0f;     ///< by how many pixels lines and points are drawn wider than they are
  };

  /** Of those that others may hide, and of those that the view alone does. */
  const Extremes& OfHideable() const { return this->ExtremesOfHideable; }
  const Extremes& OfViewAlone() const { return this->ExtremesOfViewAlone; }

  /** How many parts others do not hide, but the view does. */
  std::size_t CountOfViewAlone() const { return this->ViewAlone.size(); }

  /** Puts 0 for those of them that lie outside of the view. */
  void CullOutside(const ScreenProjection& view, std::vector<std::uint8_t>& visible) const;

  /**
   * Has parts show that were found hidden where they are, but not where a device may draw them: beside their faces, and those that the eye sees from their edge at any depth. And all wireframes:
   * it draws lines that are seen nearly from their end beyond it, at any depth, too.
   * @param culler   that found them hidden
   * @param drawn    one for each part, 1 for those that are drawn
   * @param visible  the same for those that may show; 1 is put for such parts within the view
   */
  void VerifyHidden(PartCuller& culler, const ScreenProjection& view,
    const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible);

  /** Whether something is drawn that is blended among what is opaque, of which it is not known where it is: then all parts in the view may show. */
  bool BlendsAnywhere() const;

  /** Whether something is drawn that is blended among what is opaque. */
  bool BlendsSomewhere() const;

  /** What that is: its class and the reason; of several, of one that has most of the screen drawn. There is one. */
  std::string DescribeBlended() const;

  /**
   * Has parts show that were found hidden, but lie on the screen where something is that is blended among what is opaque: they may shine through.
   * @param drawn, visible  as above
   */
  void ShowBehindBlended(const SampleGrid& samples, const ScreenProjection& view,
    const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible) const;

  /** Whether there are props that are always drawn, which may draw more where anything is translucent. */
  bool HasOthersThanParts() const;

  /**
   * Has one prop that is translucent show, if there are any and all of them would be left out.
   * @param visible  as above; `reason` is put for the parts of that prop
   */
  void KeepOneTranslucent(std::vector<std::uint8_t>& visible, std::uint8_t reason) const;

  /** Likewise has one prop show, of whatever kind. */
  void KeepOne(std::vector<std::uint8_t>& visible, std::uint8_t reason) const;

  /** What became of a prop in a frame. */
  struct Fate
  {
    const RendererView& View;
    const std::vector<std::uint8_t>& Visible; ///< at the end of the frame, as Showing
    const CullingDecision& Decision;
  };

  /** Why a prop was drawn in the frame of the last update, or that it was not, in words. */
  std::string Explain(vtkProp* prop, const Fate& fate) const;

  Occluder OccluderOf(std::uint32_t part) override;
  void PrefetchOccluder(std::uint32_t part) const override;

private:
  /**
   * What was known of a prop when it was last looked at. What pointers lead to is there as long as the times of what holds them have
   * not changed.
   */
  struct alignas(64) Part // what is read in each frame fills two cache lines
  {
    vtkMTimeType PropTime = 0;
    vtkActor* Actor = nullptr; ///< null if it cannot be hidden
    vtkShaderProperty* Shader = nullptr;
    vtkMTimeType ShaderTime = 0;
    vtkPolyDataMapper* Mapper = nullptr; ///< that draws (DrawingMapper.h)
    vtkMTimeType MapperTime = 0;
    vtkTrivialProducer* Producer =
      nullptr; ///< of the data; null if something makes them (Pipeline)
    vtkMTimeType ProducerTime = 0;
    vtkPolyData* Data = nullptr;
    vtkMTimeType DataTime = 0;
    std::shared_ptr<PartGeometry> Geometry;
    DividedMapper* Divided = nullptr;            ///< the mapper, if it may draw parts one by one
    std::shared_ptr<const MapperParts> Division; ///< null if it does not
    bool HasTextures = false;
    bool IsOpaque = false; ///< textures aside
    bool MayHide = false;
    bool HasBackFaces = true; ///< that are drawn
    bool IsWireframe = false;
    bool IsOfViewAlone = false; ///< whether others do not hide it, but the view does
    bool HasSurfaceMapper = false;
    glm::dmat4 ToWorld{ 1.0 }; ///< from the origin
    glm::dmat4 FromWorld{ 1.0 };
    glm::dvec3 Sums{ 0.0 }; ///< of absolute values, that lead to world coordinates
    DeviceCoordinates Drawn;
    float Growth = 0.0f;
    std::vector<std::uint32_t> Pieces;         ///< the parts of the division
    Box InView;                                ///< its box if it is of the view alone
    vtkDataSetMapper* SurfaceMapper = nullptr; ///< that has the other mapper draw, if one does
    vtkMTimeType SurfaceMapperTime = 0;
    vtkDataSet* Input = nullptr; ///< of that one, if its own filter makes a surface of it
    vtkMTimeType InputTime = 0;
    vtkAlgorithm* Filter = nullptr;
    vtkMTimeType FilterTime = 0;
    PipelineState Pipeline;
    const PropRow* AlwaysDrawnBy = nullptr; ///< the rule by which it is; null if it may be left out
    const PropRow* ViewAloneBy = nullptr;   ///< if IsOfViewAlone, the rule by which it is
    const PropRow* HidesNothingBy =
      nullptr; ///< a rule by which it hides nothing, whatever the frame
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
  std::vector<vtkProp*> PropOf;                ///< each part; null for pieces
  std::vector<vtkWeakPointer<vtkProp>> Living; ///< the same; null once they are gone
  std::vector<vtkMTimeType> SeenIn;            ///< of each part the last update that had it
  std::vector<Box> BoxOf;
  std::vector<std::uint8_t> HasPieces; ///< each part
  std::vector<Blending> Blends;        ///< each prop
  std::vector<std::uint32_t> Drawn;    ///< in the order of the props
  std::vector<std::uint8_t> AreSame;   ///< of those, which are surely as they were
  std::vector<std::uint32_t> Spare;    ///< parts that belong to no prop
  std::unordered_map<vtkProp*, std::uint32_t> Index;
  std::unordered_map<vtkPolyData*, std::weak_ptr<PartGeometry>> Geometries;
  std::vector<std::shared_ptr<PartGeometry>> Kept; ///< of parts that are found again
  std::uint32_t Cursor = 0;                        ///< the part behind the last one that was found
  std::unordered_map<vtkActor*, bool> AreOpaque;   ///< textures of actors, in this frame
  vtkMTimeType Frame = 0;                          ///< counts updates
  vtkMTimeType Looks = 0;                          ///< counts how often all was looked at
  bool HasMadeData = false;                        ///< whether a filter has, since then
  bool HasImagesToMake = false;                    ///< whether drawing has, for textures
  LooseOctree Boxes;
  std::pair<int, vtkTypeBool> Settings{}; ///< of the whole program, as they were
  glm::dvec3 Middle{ 0.0 };
  Extremes ExtremesOfHideable;
  Extremes ExtremesOfViewAlone;
  std::vector<BoxedPart> ViewAlone; ///< parts of the view alone
};

}

#endif
