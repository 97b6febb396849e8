/**
 * What the declarations that are joined to mappers' shaders need of the driver, where fragments go to buffers.
 */
#ifndef VITRINE_TRANSPARENCY_COMMON_FILL_EXTENSIONS_H
#define VITRINE_TRANSPARENCY_COMMON_FILL_EXTENSIONS_H

#include <vector>

namespace vitrine
{

/**
 * Extensions of GLSL 1.50, in which VTK writes mappers' shaders, that storing a fragment in a buffer takes
 * (Shaders/FragmentCapture.glsl, LinkedListFillDec.glsl, TruthFillDec.glsl).
 */
inline const std::vector<const char*>& FillExtensions()
{
  static const std::vector<const char*> extensions = { "GL_ARB_explicit_attrib_location",
    "GL_ARB_gpu_shader5", "GL_ARB_shader_bit_encoding", "GL_ARB_shader_image_load_store",
    "GL_ARB_shader_storage_buffer_object", "GL_ARB_shading_language_420pack" };
  return extensions;
}

}
#endif
