#include "lighting/deferred/MaterialTable.h"

#include "gl/BufferTexels.h"
#include "gl/Capabilities.h"
#include "scene/ClassName.h"
#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstring>

namespace vitrine
{

namespace
{

/** Floats hold all integers up to this one. */
constexpr std::int64_t LargestNumber = 1 << 24;

/** Returns true if a mapper draws all of an actor with the property's values, provided its shader uses these. */
bool IsDrawnAsPropertySays(vtkAbstractMapper* mapper, vtkActor* actor)
{
  const bool isKnown =
    IsOfClass(mapper, "vtkOpenGLPolyDataMapper") || IsOfClass(mapper, "vtkCulledPolyDataMapper");
  vtkProperty* const property = actor->GetProperty();
  return isKnown && !static_cast<vtkMapper*>(mapper)->GetSelection() &&
    !property->GetVertexVisibility();
}

/** Computes a product in floats, as a shader does. */
void PutProduct(double intensity, const double* color, float (&product)[3])
{
  for (int channel = 0; channel < 3; ++channel)
  {
    product[channel] = static_cast<float>(intensity) * static_cast<float>(color[channel]);
  }
}

VitrineMaterial MaterialOf(vtkProperty* property)
{
  VitrineMaterial material{};
  PutProduct(property->GetDiffuse(), property->GetDiffuseColor(), material.Diffuse);
  PutProduct(property->GetSpecular(), property->GetSpecularColor(), material.Specular);
  PutProduct(property->GetAmbient(), property->GetAmbientColor(), material.Ambient);
  material.SpecularPower = static_cast<float>(property->GetSpecularPower());
  return material;
}
}

void MaterialTable::Clear()
{
  this->Materials.clear();
  this->Numbers.clear();
}

int MaterialTable::NumberOf(vtkAbstractMapper* mapper, vtkProp* prop)
{
  vtkActor* const actor = vtkActor::SafeDownCast(prop);
  if (!actor || !IsDrawnAsPropertySays(mapper, actor))
  {
    return -1;
  }
  const VitrineMaterial material = MaterialOf(actor->GetProperty());
  Words words;
  std::memcpy(words.data(), &material, sizeof(material));
  const auto known = this->Numbers.find(words);
  if (known != this->Numbers.end())
  {
    return known->second;
  }
  const auto number = static_cast<int>(this->Materials.size());
  const std::int64_t most = LargestBufferTexture() / VITRINE_MATERIAL_TEXELS;
  if (number >= std::min(most, LargestNumber))
  {
    return -1;
  }
  this->Materials.push_back(material);
  this->Numbers.emplace(words, number);
  return number;
}

std::string MaterialTable::Write()
{
  return WriteOtherTexels(
    this->Table, this->Written, this->Materials, GL_RGBA32F, VITRINE_MATERIAL_TEXELS, "materials");
}

void MaterialTable::Release()
{
  this->Table.Release();
}

void MaterialTable::Bind(vtkOpenGLState* state)
{
  this->Unit = std::make_unique<ScopedTextureUnit>(
    state, GL_TEXTURE_BUFFER, this->Table.Texture(), WhenTaken::FAIL);
}

void MaterialTable::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("vitrineMaterials", this->Unit->Unit());
}

}
