/**
 * Bounds the factor from light at a surface to colour in the picture.
 */
#ifndef VITRINE_LIGHTING_FORWARD_MATERIAL_GAIN_H
#define VITRINE_LIGHTING_FORWARD_MATERIAL_GAIN_H

class vtkRenderer;

namespace vitrine
{

/**
 * Returns how much the sum of light at a point may be off if no channel of the picture, in [0, 1], may be off by more
 * than `error`. It is the minimum over a renderer's actors.
 *
 * - Phong shading reflects at most its diffuse and specular coefficients.
 * - Physically based shading reflects at most as much as a mirror of its roughness a: D is at most 1 / (pi a^2), and
 *   masking times the cosine is at most 1 / 2a (B. Walter et al., Microfacet models for refraction through rough
 *   surfaces, EGSR 2007). It then takes the root of 2.2 of the sum.
 *
 * It is 0 if there is no bound: with textures, anisotropy, a clear coat or a roughness of 0 in physically based
 * shading.
 */
double BudgetOfLight(vtkRenderer* renderer, double error);

}

#endif
