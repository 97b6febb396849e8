#ifndef VITRINE_SCENE_PART_SHADER_H
#define VITRINE_SCENE_PART_SHADER_H

#include "gl/GLObjects.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLVertexArrayObject;
class vtkPolyDataMapper;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;

namespace vitrine
{

/**
 * Takes the numbers of parts (PartNumbers) into the fragment shaders of VTK's mappers. A render pass calls Join() in
 * PostReplaceShaderValues() and SetParameters() in SetShaderParameters(). Fragment code reads `vitrinePart` and
 * `vitrinePartAndSide` (Shaders/PartRead.glsl).
 *
 * A prop without blocks has a uniform. Mappers of composite data draw their blocks from one buffer; its vertices get an
 * attribute with the flat index of their block. Geometry shaders, which draw wide lines, tubes and edges, pass it on.
 * Mappers of glyphs and impostors draw other mappers or none; they have the number of the prop.
 */
class PartShader
{
public:
  /** Set the renderer whose numbers count, before its props are drawn. */
  void SetRenderer(vtkRenderer* renderer) { this->Renderer = renderer; }

  /**
   * Set the prop that is being drawn. Followers and props of several levels of detail draw an actor of their own in
   * their place. Actors within assemblies are parts of their own. With null, each actor stands for itself.
   */
  void SetDrawnProp(vtkProp* prop) { this->Drawn = prop; }

  /**
   * Declare the part in a mapper's shaders. Call it before the tag //VTK::DepthPeeling::Dec is replaced. Declares it
   * once, also if another pass has done so. Returns an error message, empty on success.
   */
  static std::string Join(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper);

  /** Set the part's uniform and attribute before a mapper draws. `vertexArray` may be null for props without blocks. */
  void SetParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray);

  /**
   * Returns the numbers of a prop's blocks in the order in which a mapper draws them. Since VTK 9.3 it is that of the
   * numbers, and before that of the addresses of their data. Returns none for a mapper without blocks.
   */
  std::vector<std::uint32_t> NumbersInOrder(vtkAbstractMapper* mapper, vtkProp* prop) const;

  /** Release the buffers of the blocks. Their context is current. */
  void Release();

  /** Bytes of the buffers of the blocks. */
  std::int64_t Bytes() const;

private:
  /** The vertices of a block in the buffer of its mapper. */
  struct Run
  {
    std::uint32_t Start;
    std::uint32_t End;
    std::uint32_t Block;

    bool operator==(const Run& other) const
    {
      return this->Start == other.Start && this->End == other.End && this->Block == other.Block;
    }
  };
  /** The attribute of a mapper's vertices. */
  struct Attribute
  {
    vtkWeakPointer<vtkPolyDataMapper> Mapper;
    std::vector<Run> Runs;
    Buffer Blocks;
  };

  static std::vector<Run> RunsOf(vtkPolyDataMapper* mapper);
  vtkProp* PartOwner(vtkProp* prop) const;
  Attribute& AttributeOf(vtkPolyDataMapper* mapper);

  vtkRenderer* Renderer = nullptr;
  vtkProp* Drawn = nullptr;
  std::unordered_map<vtkPolyDataMapper*, Attribute> Attributes;
  std::size_t MostAttributes = 64; ///< the number from which those of deleted mappers are removed
};

}

#endif
