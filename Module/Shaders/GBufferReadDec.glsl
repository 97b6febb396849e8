// Declarations for the fragment shader that lights the G-buffer. It reads the G-buffer's layers at the pixel, or at the
// shaded sample, and the table of materials.
#include "GBufferSample.glsl"

#if VITRINE_SAMPLES > 0
#define VITRINE_SAMPLE gl_SampleID
#else
#define VITRINE_SAMPLE 0
#endif

vec4 vitrineGBufferAt(int layer)
{
  return vitrineGBufferSample(layer, VITRINE_SAMPLE);
}

// The inputs of Phong's formulas. The fourth components hold the factor of textures.
struct VitrineMaterialValues
{
  vec4 Base;
  vec4 Gloss;
  vec4 Own;
  float SpecularPower;
};

uniform samplerBuffer vitrineMaterials;

VitrineMaterialValues vitrineMaterialAt(int number)
{
  int texel = VITRINE_MATERIAL_TEXELS * number;
  vec4 diffuse = texelFetch(vitrineMaterials, texel);
  return VitrineMaterialValues(vec4(diffuse.xyz, 1.0),
    vec4(texelFetch(vitrineMaterials, texel + 1).xyz, 1.0),
    vec4(texelFetch(vitrineMaterials, texel + 2).xyz, 1.0), diffuse.w);
}

VitrineMaterialValues vitrineValuesAt(float shows, float numberOrPower)
{
  if (shows == VITRINE_SHOWS_MATERIAL)
  {
    return vitrineMaterialAt(int(numberOrPower));
  }
  return VitrineMaterialValues(vitrineGBufferAt(VITRINE_GBUFFER_BASE),
    vitrineGBufferAt(VITRINE_GBUFFER_GLOSS), vitrineGBufferAt(VITRINE_GBUFFER_OWN), numberOrPower);
}
