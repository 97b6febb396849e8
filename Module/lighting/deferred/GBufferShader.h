/**
 * Splits the shader that VTK's mappers write for one light. The inputs of the lighting formulas are written to the
 * G-buffer, and the same formulas light the pixels from there.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_G_BUFFER_SHADER_H
#define VITRINE_LIGHTING_DEFERRED_G_BUFFER_SHADER_H

#include <string>

namespace vitrine
{

/** VTK's formulas that light a pixel. */
enum class Shading
{
  Phong,
  Physical
};

/**
 * Makes a mapper's fragment shader write the G-buffer. Returns an empty string, or what is unexpected in the shader.
 *
 * If the shader takes its material from the property only, it gets a uniform vitrineMaterial: the number in the table
 * of materials, or -1. A shader whose formulas have inputs that the G-buffer does not hold is lit immediately, by the
 * loop over lights. Its pixels are written as finished.
 */
std::string WriteGBuffer(std::string& fragmentShader);

/** The way in which a pixel of the G-buffer gathers its light. */
enum class Gathering
{
  Loop, ///< a loop over the lights of its cluster or tile
  Add,  ///< each light is added to the sums
  Sums  ///< the sums are read
};

struct GBufferReading
{
  Shading Formulas;
  Gathering Lights;
  int Samples; ///< number of samples of the G-buffer; 0 without multisampling
  /** True if all pixels of the G-buffer have a material number. */
  bool HasOnlyMaterials;
};

/**
 * Makes shaders light the pixels of the G-buffer. The geometry is in NDC of the viewport: the whole viewport, or for
 * Gathering::Add a rectangle for each light. Returns an empty string, or what is unexpected in the shaders.
 */
std::string ReadGBuffer(
  std::string& vertexShader, std::string& fragmentShader, const GBufferReading& reading);

}

#endif
