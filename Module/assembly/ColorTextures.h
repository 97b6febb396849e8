/**
 * The textures that give a property's colour: that of lit parts, as VTK calls it, and that of unlit ones.
 */
#ifndef VITRINE_ASSEMBLY_COLOR_TEXTURES_H
#define VITRINE_ASSEMBLY_COLOR_TEXTURES_H

#include "vtkProperty.h"

namespace vitrine
{

inline constexpr const char* LIT_COLOR_TEXTURE = "albedoTex";
inline constexpr const char* UNLIT_COLOR_TEXTURE = "unlitTex";

inline bool HasColorTexture(vtkProperty* property)
{
  return property->GetTexture(LIT_COLOR_TEXTURE) || property->GetTexture(UNLIT_COLOR_TEXTURE);
}

inline void RemoveColorTextures(vtkProperty* property)
{
  property->RemoveTexture(LIT_COLOR_TEXTURE);
  property->RemoveTexture(UNLIT_COLOR_TEXTURE);
}

}

#endif
