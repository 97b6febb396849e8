#include "chart/ChartMeasures.h"

#include <cmath>

namespace program
{

double NumberOrNaN(const Json& row, const char* key)
{
  return row.contains(key) && row[key].is_number() ? row[key].get<double>() : std::nan("");
}

namespace
{
double ErrorOrNaN(const Json& row, const char* key)
{
  return row.contains("error") && row["error"].is_object() ? NumberOrNaN(row["error"], key)
                                                           : std::nan("");
}
}

const std::vector<ChartMeasure>& CostMeasures()
{
  static const std::vector<ChartMeasure> costs = {
    { "time", "Frame time as a ratio", [](const Json& row) { return NumberOrNaN(row, "ratio"); } },
    { "memory", "Memory in MiB",
      [](const Json& row) { return NumberOrNaN(row, "bytes") / (1024.0 * 1024.0); } },
    { "passes", "Geometry passes",
      [](const Json& row) { return NumberOrNaN(row, "geometry_passes"); } },
  };
  return costs;
}

const std::vector<ChartMeasure>& ErrorMeasures()
{
  static const std::vector<ChartMeasure> errors = {
    { "max", "Largest error in 1/255",
      [](const Json& row) { return 255.0 * ErrorOrNaN(row, "max"); } },
    { "rmse", "RMSE in 1/255", [](const Json& row) { return 255.0 * ErrorOrNaN(row, "rmse"); } },
    // decibels are a logarithm themselves; 0 stands for the cap, which is no error at all
    { "psnr", "99 - PSNR in dB", [](const Json& row) { return 99.0 - ErrorOrNaN(row, "psnr"); },
      /* IsLogarithmic= */ false },
    { "ssim", "1 - SSIM", [](const Json& row) { return 1.0 - ErrorOrNaN(row, "ssim"); } },
    { "flip", "Mean FLIP", [](const Json& row) { return ErrorOrNaN(row, "flip"); } },
    { "wrong_pixels", "Wrong pixels in %",
      [](const Json& row) { return 100.0 * ErrorOrNaN(row, "wrong_pixels"); } },
  };
  return errors;
}

}
