/** The GLSL extensions that a mapper's shader needs to store fragments in buffers. */
#ifndef VITRINE_TRANSPARENCY_COMMON_FILL_EXTENSIONS_H
#define VITRINE_TRANSPARENCY_COMMON_FILL_EXTENSIONS_H

#include <vector>

namespace vitrine
{

/**
 * The extensions of GLSL 1.50 that storing a fragment in a buffer requires (Shaders/FragmentCapture.glsl,
 * LinkedListFillDec.glsl, TruthFillDec.glsl). VTK writes its mappers' shaders in GLSL 1.50.
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
