/**
 * Colours of numbers.
 */
#ifndef VITRINE_COLOR_MAPS_H
#define VITRINE_COLOR_MAPS_H

#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace program
{

/** Names of the maps, all of which are perceptual. */
std::vector<std::string> ColorMapNames();

/** What MakeColorMap() shows for what is not a number. */
inline constexpr const char* NotANumberColorName = "magenta";

/** A map by its name over a range, whose ends have different values. Values beyond the range have its ends' colours. */
vtkSmartPointer<vtkColorTransferFunction> MakeColorMap(
  const std::string& name, double low, double high);

}
#endif
