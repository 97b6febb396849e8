#include "assembly/PartLooks.h"

#include "assembly/AssemblyLooks.h"
#include "assembly/ColorTextures.h"
#include "vtkActor.h"
#include "vtkAssemblyActors.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace
{
/** What a shader does with the alpha of the texture of the base colour, in place of what VTK does. */
std::string TextureAlphaCode(vtkInformation* keys)
{
  if (!keys || !keys->Has(vtkAssemblyActors::ALPHA_CUTOFF()))
  {
    return "opacity *= albedoSample.a;"; // glTF 2.0, 3.9.2
  }
  const double cutoff = keys->Get(vtkAssemblyActors::ALPHA_CUTOFF());
  std::ostringstream code;
  code.imbue(std::locale::classic()); // GLSL has decimal points.
  code << "if (albedoSample.a < " << std::fixed << cutoff << ") { discard; }";
  return cutoff > 0.0 ? code.str() : "";
}

bool HasLinearColors(vtkProperty* property)
{
  return property->GetInterpolation() == VTK_PBR && property->GetLighting();
}

std::array<double, 3> Raised(std::array<double, 3> color, double exponent)
{
  std::transform(color.begin(), color.end(), color.begin(),
    [exponent](double value) { return std::pow(value, exponent); });
  return color;
}
}

namespace vitrine
{

bool HasColors(vtkPolyData* geometry)
{
  vtkDataArray* const scalars = geometry->GetPointData()->GetScalars();
  return scalars && scalars->GetNumberOfComponents() >= 3;
}

std::array<double, 3> ColorToHold(vtkProperty* property, const std::array<double, 3>& shown)
{
  return HasLinearColors(property) ? Raised(shown, GAMMA) : shown;
}

std::array<double, 3> ShownColor(vtkProperty* property)
{
  std::array<double, 3> color{};
  if (property->GetDiffuse() > 0.0)
  {
    property->GetDiffuseColor(color.data());
  }
  else
  {
    property->GetColor(color.data()); // which mixes in the colour of highlights
  }
  return HasLinearColors(property) ? Raised(color, 1.0 / GAMMA) : color;
}

void SetKeys(vtkActor* actor, vtkInformation* keys)
{
  if (keys)
  {
    vtkNew<vtkInformation> copy;
    copy->Copy(keys);
    actor->SetPropertyKeys(copy);
  }
  if (actor->GetProperty()->GetTexture(LIT_COLOR_TEXTURE))
  {
    // The first is VTK's up to 9.5, and the second VTK's from then on.
    for (const char* const code :
      { "opacity = albedoSample.a;", "opacity = opacityUniform * albedoSample.a;" })
    {
      actor->GetShaderProperty()->AddFragmentShaderReplacement(
        code, /* replaceFirst= */ false, TextureAlphaCode(keys), /* replaceAll= */ true);
    }
  }
}

}
