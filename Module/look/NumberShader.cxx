#include "look/NumberShader.h"

#include "gl/BufferTexels.h"
#include "scene/PartNumbers.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

void NumberShader::Begin(const ChosenParts& parts, const std::vector<vtkProp*>& props)
{
  this->Unit.reset();
  this->NumberOf.clear();
  this->RowOf.clear();
  this->Numbers.clear();
  for (vtkProp* prop : props)
  {
    const std::vector<std::uint32_t> numbers = parts.NumbersOf(prop);
    if (BlocksOf(prop))
    {
      this->RowOf[prop] = static_cast<int>(this->Numbers.size());
      this->Numbers.insert(this->Numbers.end(), numbers.begin(), numbers.end());
    }
    else if (!numbers.empty())
    {
      this->NumberOf[prop] = numbers.front();
    }
  }
}

std::string NumberShader::Join(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper)
{
  const std::string problem =
    PartShader::Join(vertexShader, geometryShader, fragmentShader, mapper);
  return problem.empty() ? ReplaceTag(fragmentShader, vtktext::DepthPeelingDec,
                             std::string(shaders::ChosenNumber) + vtktext::DepthPeelingDec)
                         : problem;
}

std::string NumberShader::SetParameters(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
  vtkAbstractMapper* mapper, vtkProp* owner, vtkProp* drawn,
  vtkOpenGLVertexArrayObject* vertexArray)
{
  this->Blocks.SetParameters(program, mapper, drawn, vertexArray);
  const auto number = this->NumberOf.find(owner);
  program->SetUniformi(
    "vitrineNumberOfProp", number == this->NumberOf.end() ? 0 : static_cast<int>(number->second));
  if (!program->IsUniformUsed("vitrineNumbers"))
  {
    return {};
  }
  const auto row = this->RowOf.find(owner);
  program->SetUniformi("vitrineNumberRow", row == this->RowOf.end() ? -1 : row->second);
  const std::string problem = this->Unit ? std::string() : this->Bind(window);
  program->SetUniformi("vitrineNumbers", this->Unit ? this->Unit->Unit() : 0);
  return problem;
}

std::string NumberShader::Bind(vtkOpenGLRenderWindow* window)
{
  if (this->Numbers.empty())
  {
    this->Numbers.push_back(0); // a sampler needs a buffer
  }
  std::string problem = WriteOtherTexels(
    this->Texels, this->Written, this->Numbers, GL_R32UI, 1, "numbers of chosen parts");
  if (problem.empty())
  {
    this->Unit = std::make_unique<ScopedTextureUnit>(
      window->GetState(), GL_TEXTURE_BUFFER, this->Texels.Texture(), WhenTaken::FAIL);
    problem = this->Unit->Unit() < 0 ? "no texture unit is free for the numbers of chosen parts"
                                     : std::string();
  }
  return problem;
}

void NumberShader::Release()
{
  this->Unit.reset();
  this->Texels.Release();
  this->Written.clear();
  this->Blocks.Release();
}

}
