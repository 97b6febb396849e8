/**
 * How what a scene shows is made to look.
 */
#ifndef VITRINE_LOOK_H
#define VITRINE_LOOK_H

#include "vtkProperty.h"
#include "vtkSmartPointer.h"

namespace program
{

struct Look
{
  double Red;
  double Green;
  double Blue;
  double Opacity;
  double Specular;
  double SpecularPower;
};

/** A property with these shares of a scene's light, and white highlights. */
vtkSmartPointer<vtkProperty> MakeProperty(const Look& look, double ambient, double diffuse);

}
#endif
