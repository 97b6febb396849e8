/** The program that converts STEP, IGES and BREP to GLB. */
#ifndef VITRINE_ASSEMBLY_CAD_CONVERTER_H
#define VITRINE_ASSEMBLY_CAD_CONVERTER_H

#include "assembly/CadConversion.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * A command with the arguments INPUT OUTPUT.glb --progress [--tolerance METRES]. It prints lines of progress and, where
 * it fails, one message on stderr. With --version it prints what it is.
 */
class CadConverter
{
public:
  /** Finds the converter. Throws AssemblyError if there is none. */
  explicit CadConverter(const CadSettings& settings);

  /** Returns what the converter says of its version. Throws AssemblyError if it cannot be run. */
  std::string Version() const;

  /** Converts a file. Throws AssemblyError if that fails. */
  void Convert(const std::filesystem::path& input, const std::filesystem::path& output,
    const CadProgress& showProgress) const;

  /** Returns the converter's name for messages. */
  std::string Name() const;

private:
  std::vector<std::string> Command;
  double Tolerance;
  double TimeLimit;
};

}

#endif
