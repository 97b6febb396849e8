#include "section/SectionShader.h"

#include "Core/section/CutPolygon.h"
#include "gl/BufferTexels.h"
#include "scene/Matrices.h"
#include "scene/PartNumbers.h"
#include "section/CapActor.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine
{

namespace
{

using vtktext::ClipDec;
using vtktext::ClipImpl;

/** Replaces tags of a shader, and keeps the first error. */
class TagText
{
public:
  explicit TagText(std::string& shader)
    : Shader(shader)
  {
  }

  /** Insert text before a tag, which stays. */
  void Before(const std::string& tag, const std::string& text) { this->Put(tag, text + tag); }

  /** Insert text after a tag, which stays. */
  void After(const std::string& tag, const std::string& text) { this->Put(tag, tag + "\n" + text); }

  const std::string& Problem() const { return this->FirstProblem; }

  void Note(const std::string& problem)
  {
    this->FirstProblem = this->FirstProblem.empty() ? problem : this->FirstProblem;
  }

private:
  void Put(const std::string& tag, const std::string& text)
  {
    // The text has the tag again, so ReplaceTag() sees it once only if the shader did.
    this->Note(ReplaceTag(this->Shader, tag, text));
  }

  std::string& Shader;
  std::string FirstProblem;
};

/** How a device has the points of a mapper: (point - Shift) * Scale. */
struct VertexFrame
{
  std::array<double, 3> Shift{ 0.0, 0.0, 0.0 };
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
  bool IsShifted = false;
};

VertexFrame FrameOf(vtkAbstractMapper* mapper)
{
  VertexFrame frame;
  auto* const drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  vtkOpenGLVertexBufferObject* const points = drawing && !drawing->IsA("vtkOpenGLGlyph3DHelper")
    ? drawing->GetVBOs()->GetVBO("vertexMC")
    : nullptr;
  if (points && points->GetCoordShiftAndScaleEnabled())
  {
    frame.IsShifted = true;
    std::copy_n(points->GetShift().begin(), 3, frame.Shift.begin());
    std::copy_n(points->GetScale().begin(), 3, frame.Scale.begin());
  }
  return frame;
}

/** Puts the equation of a plane in model coordinates into those that the device has. */
void PutInFrame(const CutPlane& plane, const VertexFrame& frame, float equation[4])
{
  double offset = plane.Offset;
  for (int axis = 0; axis < 3; ++axis)
  {
    equation[axis] = static_cast<float>(plane.Normal[axis] / frame.Scale[axis]);
    offset += plane.Normal[axis] * frame.Shift[axis];
  }
  equation[3] = static_cast<float>(offset);
}

/**
 * Returns how much farther than its margin a plane in model coordinates is moved for an actor's points that the device
 * has unshifted.
 */
double FurtherMargin(const CutPlane& plane, double margin, vtkActor* actor)
{
  const double* const bounds = actor->GetMapper() ? actor->GetMapper()->GetBounds() : nullptr;
  if (!bounds || !(bounds[0] <= bounds[1]))
  {
    return 0.0;
  }
  const glm::dvec3 greatest = glm::max(glm::abs(glm::dvec3(bounds[0], bounds[2], bounds[4])),
    glm::abs(glm::dvec3(bounds[1], bounds[3], bounds[5])));
  return std::max(0.0, MarginOf(plane, greatest) - margin);
}
}

vtkStandardNewMacro(SectionShader);

namespace
{

/** Returns the axis of WC that is nearest to the upwards direction of the view. Small turns of the view keep it. */
glm::dvec3 UpOf(vtkRenderer* renderer)
{
  double up[3];
  renderer->GetActiveCamera()->GetViewUp(up);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(up[i]) > std::abs(up[axis]) ? i : axis;
  }
  glm::dvec3 nearest(0.0);
  nearest[axis] = up[axis] < 0.0 ? -1.0 : 1.0;
  return nearest;
}
}

void SectionShader::BeginFrame(vtkRenderer* renderer, const SectionPlanes& planes)
{
  this->Renderer = renderer;
  this->Blocks.SetRenderer(renderer);
  this->Rows.clear();
  this->MaskTable.clear();
  if (this->Planes.Planes.size() != planes.Planes.size())
  {
    this->Stage.Modified();
  }
  this->Planes = planes;
}

void SectionShader::SetSamples(int samples)
{
  if (this->Samples != samples)
  {
    this->Samples = samples;
    this->Stage.Modified();
  }
}

void SectionShader::EndFrame()
{
  this->MaskUnit.reset();
}

void SectionShader::Release(vtkWindow* window)
{
  if (this->Context.LivesIn(window))
  {
    this->Release();
  }
}

void SectionShader::Release()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow*)
    {
      this->MaskUnit.reset();
      this->MaskBuffer.Release();
      this->Blocks.Release();
    });
  // If the context is gone, the names of the objects may be those of others.
  this->MaskUnit.reset();
  this->MaskBuffer = Buffer();
  this->Blocks = PartShader();
  this->Blocks.SetRenderer(this->Renderer);
  this->Context.LetGo();
}

void SectionShader::UseWindow()
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (!this->Context.LivesIn(window))
  {
    this->Release();
    this->Context.Hold(window);
  }
}

bool SectionShader::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (this->Planes.Planes.empty() || !vtkActor::SafeDownCast(prop))
  {
    return true;
  }
  const std::string count =
    "#define VITRINE_SECTION_PLANES " + std::to_string(this->Planes.Planes.size()) + "\n";
  TagText vertex(vertexShader);
  TagText geometry(geometryShader);
  TagText fragment(fragmentShader);
  const std::string distances = shaders::SectionVertexImpl;
  if (geometryShader.empty())
  {
    vertex.Before(ClipDec, count + shaders::SectionVertexDec);
    // Shaders of glyphs have the vertex in the coordinates of their mapper in a variable.
    const bool isGlyph = vertexShader.find(vtktext::GlyphImpl) != std::string::npos;
    vertex.Before(ClipImpl,
      std::string("#define VITRINE_SECTION_VERTEX ") + (isGlyph ? "vertex\n" : "vertexMC\n") +
        distances);
  }
  else
  {
    vertex.Before(ClipDec, "out vec4 vitrineSectionVertex;\n");
    vertex.Before(ClipImpl, "  vitrineSectionVertex = vertexMC;\n");
    geometry.Before(ClipDec, count + shaders::SectionGeometryDec);
    geometry.Before(
      ClipImpl, "#define VITRINE_SECTION_VERTEX vitrineSectionVertex[i]\n" + distances);
  }
  fragment.Before(vtktext::CustomUniformsDec, count + shaders::SectionFragmentDec);
  if (CapActor::SafeDownCast(prop))
  {
    vertex.Before(ClipDec, shaders::CapVertexDec);
    vertex.Before(ClipImpl, shaders::CapVertexImpl);
    fragment.Before(vtktext::CustomUniformsDec,
      "#define VITRINE_CUT_SAMPLES " + std::to_string(this->Samples) + "\n" + shaders::CapDec);
    if (this->Samples > 0)
    {
      fragment.After(vtktext::SystemDec, "#extension GL_ARB_sample_shading : require\n");
    }
    fragment.Before(ClipImpl, shaders::CapImpl);
    fragment.After(vtktext::ColorImpl, shaders::CapColor);
  }
  else
  {
    fragment.Before(ClipImpl, shaders::SectionFragmentImpl);
    if (BlocksOf(prop))
    {
      fragment.Note(PartShader::Join(vertexShader, geometryShader, fragmentShader, mapper));
    }
  }
  for (const TagText* text : { &vertex, &geometry, &fragment })
  {
    if (!text->Problem().empty())
    {
      vtkErrorMacro(<< "A section cannot cut " << (prop ? prop->GetClassName() : "a prop") << ": "
                    << text->Problem() << ". It is not drawn.");
      fragmentShader = "//VTK::System::Dec\nvoid main()\n{\n  discard;\n}\n";
      return true;
    }
  }
  return true;
}

bool SectionShader::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* vertexArray)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  if (!actor || this->Planes.Planes.empty() || !program->IsUniformUsed("vitrineSectionPlanes"))
  {
    return true;
  }
  actor->ComputeMatrix();
  const glm::dmat4 toWorld = MatrixOf(actor->GetMatrix());
  const VertexFrame frame = FrameOf(mapper);
  auto* const cap = dynamic_cast<CapActor*>(actor);
  std::vector<std::array<float, 4>> equations(this->Planes.Planes.size());
  for (std::size_t i = 0; i < equations.size(); ++i)
  {
    const CutPlane plane = this->Planes.Planes[i].In(toWorld);
    const double further =
      frame.IsShifted || cap ? 0.0 : FurtherMargin(plane, this->Planes.Margins[i], actor);
    PutInFrame(plane.MovedBy(further), frame, equations[i].data());
  }
  program->SetUniform4fv("vitrineSectionPlanes", static_cast<int>(equations.size()),
    reinterpret_cast<const float(*)[4]>(equations.data()));
  if (cap)
  {
    const CutPlane& plane = this->Planes.Planes[static_cast<std::size_t>(cap->Plane)];
    const PlaneAxes axes = AxesOf(plane, UpOf(this->Renderer));
    float places[2][4];
    PutInFrame({ axes.U, 0.0 }, frame, places[0]);
    PutInFrame({ axes.V, 0.0 }, frame, places[1]);
    program->SetUniform4fv("vitrineCapAxes", 2, places);
    this->SetCapUniforms(program, actor);
    return true;
  }
  const PlaneMasks masks = this->MasksOf(actor);
  const int bits[2] = { static_cast<int>(masks.Any), static_cast<int>(masks.All) };
  program->SetUniform2i("vitrineSectionMasks", bits);
  if (program->IsUniformUsed("vitrineBlockMasks"))
  {
    this->UseWindow();
    this->Blocks.SetParameters(program, mapper, prop, vertexArray);
    this->SetBlockMasks(program, prop);
  }
  return true;
}

/** Sets the masks of the prop's blocks, from the first time in a frame at which a prop needs them. */
void SectionShader::SetBlockMasks(vtkShaderProgram* program, vtkProp* prop)
{
  const auto [row, isNew] = this->Rows.try_emplace(prop, -1);
  if (isNew)
  {
    const std::vector<PlaneMasks> masks = this->MasksOfBlocks(prop);
    if (!masks.empty())
    {
      row->second = static_cast<int>(this->MaskTable.size());
      for (const PlaneMasks& mask : masks)
      {
        this->MaskTable.push_back({ mask.Any, mask.All });
      }
      this->MaskUnit.reset();
    }
  }
  program->SetUniformi("vitrineSectionRow", row->second);
  if (!this->MaskUnit)
  {
    if (this->MaskTable.empty())
    {
      this->MaskTable.push_back({ 0, 0 }); // a sampler needs a buffer
    }
    const std::string problem =
      WriteTexels(this->MaskBuffer, this->MaskTable, GL_RG32UI, 1, "planes of blocks");
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem);
    }
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
    this->MaskUnit = std::make_unique<ScopedTextureUnit>(
      window->GetState(), GL_TEXTURE_BUFFER, this->MaskBuffer.Texture(), WhenTaken::FAIL);
  }
  if (this->MaskUnit->Unit() < 0)
  {
    vtkErrorMacro("No texture unit is free for planes of blocks.");
    return;
  }
  program->SetUniformi("vitrineBlockMasks", this->MaskUnit->Unit());
}

}
