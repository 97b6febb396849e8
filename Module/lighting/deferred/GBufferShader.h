/**
 * What VTK's mappers write for one light, cut in two: what it takes goes into the G-buffer, and is lit from there by the same formulas.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_G_BUFFER_SHADER_H
#define VITRINE_LIGHTING_DEFERRED_G_BUFFER_SHADER_H

#include <string>

namespace vitrine
{

/** Which of VTK's formulas light a pixel. */
enum class Shading
{
  Phong,
  Physical
};

/**
 * Has a mapper's fragment shader write the G-buffer. Where it takes a material from the property alone, it has a uniform vitrineMaterial: its number in the table
 * of materials, or -1. What takes formulas that the G-buffer has no room for is lit there and then, by the loop over
 * lights, and written as finished. Returns an empty string, or what is not as it should be.
 */
std::string WriteGBuffer(std::string& fragmentShader);

/** How a pixel of the G-buffer is lit. */
enum class Gathering
{
  Loop, ///< over the lights of its cluster, or tile
  Add,  ///< light by light, each added to sums
  Sums  ///< from these
};

struct GBufferReading
{
  Shading Formulas;
  Gathering Lights;
  int Samples; ///< of the G-buffer; 0 for one that is not multisampled
  bool
    HasOnlyMaterials; ///< whether all that the G-buffer shows has its number in the table of materials
};

/**
 * Has the shaders of what is given in coordinates of the viewport, and of lights where it adds them, light what the G-buffer shows there. Returns an
 * empty string, or what is not as it should be.
 */
std::string ReadGBuffer(
  std::string& vertexShader, std::string& fragmentShader, const GBufferReading& reading);

}

#endif
