#include "scene/PartShader.h"

#include "gl/VitrineOpenGL.h"
#include "scene/PartNumbers.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include "vtkAbstractMapper.h"
#include "vtkColor.h" // vtkCompositeMapperHelper2.h lacks it
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
#include "vtkCompositeMapperHelper2.h"
#else
#include "vtkOpenGLBatchedPolyDataMapper.h"
#endif

#include <algorithm>

namespace vitrine
{

namespace
{

const char* const BlockOfVertex = "vitrineBlockOfVertex";
const char* const FirstPart = "vitrineFirstPart";

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
using BlockMapper = vtkCompositeMapperHelper2;
constexpr bool DrawsBlocksByNumber = false;
#else
using BlockMapper = vtkOpenGLBatchedPolyDataMapper;
constexpr bool DrawsBlocksByNumber = true;
#endif

/** Gives access to the table of a mapper of blocks, which is protected. */
class BlockTable : public BlockMapper
{
public:
  /** Calls `visit` with the start and the end of the vertices of each block, and its flat index. */
  template <class Visit>
  static void ForEach(BlockMapper* mapper, const Visit& visit)
  {
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
    for (const auto& block : mapper->*(&BlockTable::Data))
    {
      visit(block.second->StartVertex, block.second->NextVertex, block.second->FlatIndex);
    }
#else
    for (const auto& block : mapper->*(&BlockTable::VTKPolyDataToGLBatchElement))
    {
      visit(block.second->StartVertex, block.second->NextVertex, block.second->Parent.FlatIndex);
    }
#endif
  }
};

/** Inserts `text` before the first `place` in the shader. Returns false if there is none. */
bool InsertBefore(std::string& shader, const std::string& place, const std::string& text)
{
  const std::size_t at = shader.find(place);
  if (at == std::string::npos)
  {
    return false;
  }
  shader.insert(at, text);
  return true;
}

const std::string Main = "void main";
}

std::string PartShader::Join(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper)
{
  if (fragmentShader.find(FirstPart) != std::string::npos)
  {
    return {};
  }
  std::string part = shaders::PartRead;
  if (BlockMapper::SafeDownCast(mapper))
  {
    const std::size_t end = vertexShader.rfind('}');
    if (end == std::string::npos)
    {
      return "the vertex shader has no end";
    }
    vertexShader.insert(end, "  vitrineBlock = vitrineBlockOfVertex;\n");
    InsertBefore(vertexShader, Main, shaders::PartVertexDec);
    if (!geometryShader.empty())
    {
      InsertBefore(geometryShader, Main, shaders::PartGeometryDec);
      InsertBeforeEach(
        geometryShader, "EmitVertex();", "vitrineBlockOfPrimitive = vitrineBlock[0]; ");
    }
    part = std::string("#define VITRINE_BLOCK ") +
      (geometryShader.empty() ? "vitrineBlock" : "vitrineBlockOfPrimitive") + "\n" + part;
  }
  return InsertBefore(fragmentShader, vtktext::DepthPeelingDec, part) ||
      InsertBefore(fragmentShader, Main, part)
    ? std::string()
    : "the fragment shader has no main function";
}

void PartShader::SetParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
  vtkOpenGLVertexArrayObject* vertexArray)
{
  if (this->Renderer && prop && program->IsUniformUsed(FirstPart))
  {
    const std::uint32_t first = PartNumbers::Of(this->Renderer).FirstOf(this->PartOwner(prop));
    program->SetUniformi(FirstPart, static_cast<int>(first));
  }
  auto* const blocks = BlockMapper::SafeDownCast(mapper);
  const GLint location = blocks && vertexArray
    ? glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), BlockOfVertex)
    : -1;
  if (location < 0)
  {
    return;
  }
  const GLuint buffer = this->AttributeOf(blocks).Blocks.Handle();
  vertexArray->Bind();
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(static_cast<GLuint>(location));
  glVertexAttribPointer(static_cast<GLuint>(location), 1, GL_FLOAT, GL_FALSE, 0, nullptr);
}

/** Returns the prop that a user sees drawn: an actor within an assembly, or the prop that `prop` stands in for. */
vtkProp* PartShader::PartOwner(vtkProp* prop) const
{
  const bool standsForItself =
    !this->Drawn || this->Drawn->IsA("vtkAssembly") || this->Drawn->IsA("vtkPropAssembly");
  return standsForItself ? prop : this->Drawn;
}

std::vector<std::uint32_t> PartShader::NumbersInOrder(
  vtkAbstractMapper* mapper, vtkProp* prop) const
{
  std::vector<std::uint32_t> numbers;
  auto* const blocks = BlockMapper::SafeDownCast(mapper);
  if (this->Renderer && prop && blocks)
  {
    const std::uint32_t first = PartNumbers::Of(this->Renderer).FirstOf(this->PartOwner(prop));
    for (const Run& run : RunsOf(blocks))
    {
      numbers.push_back(first + run.Block);
    }
    if (DrawsBlocksByNumber)
    {
      std::sort(numbers.begin(), numbers.end());
    }
  }
  return numbers;
}

std::vector<PartShader::Run> PartShader::RunsOf(vtkPolyDataMapper* mapper)
{
  std::vector<Run> runs;
  BlockTable::ForEach(static_cast<BlockMapper*>(mapper),
    [&](std::uint32_t start, std::uint32_t end, std::uint32_t block) {
      runs.push_back({ start, end, block });
    });
  return runs;
}

/** Returns the attribute of a mapper, which has a value for each vertex of its buffer. */
PartShader::Attribute& PartShader::AttributeOf(vtkPolyDataMapper* mapper)
{
  if (this->Attributes.size() > this->MostAttributes)
  {
    for (auto at = this->Attributes.begin(); at != this->Attributes.end();)
    {
      const bool isGone = at->second.Mapper == nullptr;
      if (isGone)
      {
        at->second.Blocks.Release();
      }
      at = isGone ? this->Attributes.erase(at) : std::next(at);
    }
    this->MostAttributes = std::max<std::size_t>(64, 2 * this->Attributes.size());
  }
  Attribute& attribute = this->Attributes[mapper];
  std::vector<Run> runs = RunsOf(mapper);
  if (attribute.Mapper == mapper && attribute.Runs == runs)
  {
    return attribute;
  }
  std::uint32_t count = 1;
  for (const Run& run : runs)
  {
    count = std::max(count, run.End);
  }
  std::vector<float> blocks(count);
  for (const Run& run : runs)
  {
    std::fill(blocks.begin() + run.Start, blocks.begin() + std::max(run.Start, run.End),
      static_cast<float>(run.Block));
  }
  const auto bytes = static_cast<std::int64_t>(blocks.size() * sizeof(float));
  attribute.Blocks.Allocate(bytes);
  attribute.Blocks.Write(0, bytes, blocks.data());
  attribute.Mapper = mapper;
  attribute.Runs = std::move(runs);
  return attribute;
}

void PartShader::Release()
{
  for (auto& attribute : this->Attributes)
  {
    attribute.second.Blocks.Release();
  }
  this->Attributes.clear();
}

std::int64_t PartShader::Bytes() const
{
  std::int64_t bytes = 0;
  for (const auto& attribute : this->Attributes)
  {
    bytes += attribute.second.Blocks.Bytes();
  }
  return bytes;
}

}
