/**
 * How much of what lights give reaches the picture.
 */
#ifndef VITRINE_LIGHTING_FORWARD_MATERIAL_GAIN_H
#define VITRINE_LIGHTING_FORWARD_MATERIAL_GAIN_H

class vtkRenderer;

namespace vitrine
{

/**
 * By how much the sum of what lights give at a point may be off, if no channel of the picture, in [0, 1], shall be off by more than `error`: the least
 * over a renderer's actors. Phong's shading gives back at most its coefficients, diffuse and specular; physically based shading at most what a mirror
 * of its roughness does (B. Walter et al., Microfacet models for refraction through rough surfaces, EGSR 2007: D is at most 1 / (pi a^2), and
 * masking times the cosine at most 1 / 2a), and takes the root of 2.2 of the sum. 0 where there is no bound: with textures of roughness,
 * anisotropy or a clear coat.
 */
double BudgetOfLight(vtkRenderer* renderer, double error);

}

#endif
