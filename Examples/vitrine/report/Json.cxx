#include "report/Json.h"

#include "Median.h"
#include "Version.h"
#include "report/Build.h"

#include <algorithm>

namespace program
{

namespace
{
Json DeviceJson(const Device& device)
{
  Json features = Json::object();
  for (const DeviceFeature& feature : device.Features)
  {
    features[feature.Name] = feature.IsThere;
  }
  Json json = { { "vendor", device.Vendor }, { "renderer", device.Renderer },
    { "gl", device.Version }, { "storage_block_bytes", device.StorageBlockBytes },
    { "buffer_texture_texels", device.BufferTextureTexels }, { "samples", device.Samples },
    { "features", features } };
  if (!device.Switches.empty())
  {
    json["switches"] = device.Switches;
  }
  return json;
}
}

Json MeasurementHead(const Device& device)
{
  return { { "vitrine", Version }, { "build", BuildJson() }, { "device", DeviceJson(device) } };
}

Json ErrorJson(const vitrine::ImageError& error)
{
  return { { "max", error.Max }, { "rmse", error.Rmse }, { "psnr", error.Psnr },
    { "ssim", error.Ssim }, { "flip", error.Flip }, { "wrong_pixels", error.WrongPixels } };
}

void AddCoincidence(Json& settings, const Coincidence& tolerance)
{
  if (tolerance.Steps > 0.0 || tolerance.Slope > 0.0)
  {
    settings["coincidence"] = { tolerance.Steps, tolerance.Slope };
  }
}

Json Spread(const std::vector<double>& milliseconds, const std::string& count)
{
  const auto [low, high] = std::minmax_element(milliseconds.begin(), milliseconds.end());
  return { { "min", *low }, { "median", Median(milliseconds) }, { "max", *high },
    { count, milliseconds.size() } };
}

std::string JsonText(const Json& document)
{
  return document.dump(2, ' ', /* ensure_ascii= */ false, Json::error_handler_t::replace) + "\n";
}

}
