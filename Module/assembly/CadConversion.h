/** Files of STEP, IGES and BREP, read by way of a converter, which is a program of its own. */
#ifndef VITRINE_ASSEMBLY_CAD_CONVERSION_H
#define VITRINE_ASSEMBLY_CAD_CONVERSION_H

#include "Core/assembly/Assembly.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace vitrine
{

/** How a file is converted. */
struct CadSettings
{
  std::string Converter; ///< a command; empty for $VITRINE_CAD_CONVERTER, or vitrine-cad
  double Tolerance =
    0.0; ///< metres that triangles may be from the shapes; 0 for the converter's own
  double TimeLimit = 0.0; ///< seconds that a conversion may take; 0 for no limit
  bool UseCache = true;
  std::string CacheFolder;      ///< empty for CadCache's own
  std::uint64_t CacheLimit = 0; ///< bytes
};

/** Takes how much is done, in [0, 1], and of what. Returns false to give up. */
using CadProgress = std::function<bool(double fraction, const std::string& task)>;

/** Whether a file is one of STEP, IGES or BREP, by its extension. Case does not count. */
bool IsCadFile(const std::filesystem::path& file);

/**
 * Read a file of STEP, IGES or BREP. Lengths are in metres, and Y is upwards.
 * @throws  AssemblyError if it cannot be read
 */
Assembly ReadCad(const std::filesystem::path& file, int scene, const CadSettings& settings,
  const CadProgress& showProgress);

}

#endif
