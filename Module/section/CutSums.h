/** Draws which part contains each point of the planes of a section. */
#ifndef VITRINE_SECTION_CUT_SUMS_H
#define VITRINE_SECTION_CUT_SUMS_H

#include "gl/GLObjects.h"
#include "gl/HeldContext.h"
#include "gl/ProgramCache.h"
#include "gl/ScopedState.h"
#include "section/CutParts.h"
#include "section/SectionPlanes.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

namespace vitrine
{

/** The numbers of hatches that parts have, by slots. */
using HatchOf = std::function<int(const CutPart&)>;

/**
 * For each plane, the closed parts that it cuts are drawn once: each face beyond the plane along the ray adds the slot
 * of its part and a hash of it by exclusive or. Faces of a solid come in pairs unless the point in the plane is inside.
 * So what remains is the slot of the part that contains it. If the hash does not fit, several parts do.
 */
class CutSums
{
public:
  /**
   * Draw the sums for the viewport and the camera that are set, unless they are those of the last call. Returns a
   * reason if they cannot be drawn, else an empty string.
   * @param samples  samples of a pixel, 0 for one
   */
  std::string Draw(
    vtkRenderer* renderer, const CutParts& parts, const SectionPlanes& planes, int samples);

  /**
   * Returns the samples of a pixel of the framebuffer that is bound for drawing. It is 0 if there is one, or if integer
   * images cannot have as many.
   */
  static int SamplesOfTarget();

  /** Write the tables by which caps look up parts, if `changes` differs from the last call. */
  std::string WriteTables(vtkRenderer* renderer, const CutParts& parts, const HatchOf& hatchOf,
    const PlaneMasks& ofInterference);

  /** Bind the sums and tables until Unbind(). Returns a reason if they cannot be bound, else an empty string. */
  std::string Bind(vtkOpenGLState* state);
  void Unbind();

  /** Set uniforms of the bound images and of the first pixel. */
  void SetUniforms(vtkShaderProgram* program, int plane, bool isTranslucent) const;

  /** The sums of a plane, as read back: pairs of slot and hash, and the size of the image. */
  struct Pixels
  {
    int Width = 0;
    int Height = 0;
    std::vector<std::array<std::uint32_t, 2>> Sums;
  };
  Pixels Read(int plane);

  /** The layer of a plane, or -1 if it cuts no part. */
  int LayerOf(std::size_t plane) const
  {
    return plane < this->Layers.size() ? this->Layers[plane] : -1;
  }

  /** The first layer of open parts, which have two for each layer: faces beyond the plane, and before it. 0 if none. */
  int FirstOpenLayer() const { return this->OpenLayer; }

  /** The matrix from WC to the clip coordinates of the last sums. */
  const glm::dmat4& ToClip() const { return this->LastKey.ToClip; }

  /** Release what is held in the context of a window, or wherever it is. */
  void Release(vtkWindow* window);
  void Release();
  std::int64_t Bytes() const;

private:
  /** What the sums depend on. */
  struct Key
  {
    std::array<int, 4> Viewport{};
    glm::dmat4 ToClip{ 0.0 };
    std::uint64_t Changes = 0;
    int Samples = 0;
    std::vector<CutPlane> Planes;
  };

  void UseWindow(vtkOpenGLRenderWindow* window);
  int GiveLayers(const CutParts& parts, std::size_t planes);
  std::string Upload(const CutParts& parts);
  std::string DrawPlanes(
    vtkOpenGLRenderWindow* window, const CutParts& parts, const SectionPlanes& planes);
  void DrawLayer(vtkShaderProgram* program, int layer, const CutParts& parts,
    std::uint32_t planeBit, bool areClosed, const glm::dvec4& beyond);
  void Connect(vtkShaderProgram* program);
  void Forget();

  HeldContext Context;
  ProgramCache Programs{ GLSL150 };
  Image2D Sums;
  Framebuffer Drawing;
  Buffer Vertices;
  Buffer Corners;
  std::size_t WrittenVertices = 0;
  std::size_t WrittenCorners = 0;
  std::uint64_t Generation = 0;
  GLuint VertexArray = 0;
  Key LastKey;
  std::vector<int> Layers; ///< of planes, -1 for those that cut nothing
  int OpenLayer = 0;

  Buffer PartTable;
  Buffer LookTable;
  std::vector<std::array<std::uint32_t, 4>> WrittenParts;
  std::vector<std::array<glm::vec4, 2>> WrittenLooks;

  std::unique_ptr<ScopedTextureUnit> SumsUnit;
  std::unique_ptr<ScopedTextureUnit> PartsUnit;
  std::unique_ptr<ScopedTextureUnit> LooksUnit;
};

}

#endif
