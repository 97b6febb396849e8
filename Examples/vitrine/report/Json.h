/**
 * What all of the program's JSON shares.
 */
#ifndef VITRINE_PROGRAM_JSON_H
#define VITRINE_PROGRAM_JSON_H

#include "methods/Device.h"
#include "methods/Method.h"
#include "study/image/ImageError.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace program
{

using Json = nlohmann::ordered_json;

template <typename T>
Json OrNull(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

/** How a document of measurements begins: {"vitrine", "build", "device"}. */
Json MeasurementHead(const Device& device);

/** {"max", "rmse", "psnr", "ssim", "flip", "wrong_pixels"}. */
Json ErrorJson(const vitrine::ImageError& error);

/** Adds "coincidence": [steps, slope] to settings, if there is a tolerance. */
void AddCoincidence(Json& settings, const Coincidence& tolerance);

/** {"min", "median", "max"} of times, of which there are some, and their number as `count`. */
Json Spread(const std::vector<double>& milliseconds, const std::string& count);

/** The text of a document, for a file or a terminal; what is not UTF-8 in it is replaced. */
std::string JsonText(const Json& document);

}
#endif
