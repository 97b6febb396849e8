/**
 * Files of STEP, IGES and BREP.
 */
#ifndef VITRINE_CAD_FILE_H
#define VITRINE_CAD_FILE_H

#include "ProgressLines.h"

#include <TDocStd_Document.hxx>

#include <filesystem>
#include <string>

namespace cad
{

/** The metres that OpenCASCADE's own unit has: lengths of a document are in millimetres, whatever the file's unit. */
inline constexpr double METERS_OF_DOCUMENT = 0.001;

/** What a file holds. */
struct CadFile
{
  Handle(TDocStd_Document) Document; ///< shapes with names, colours and places, in millimetres
  std::string LengthUnit;            ///< in which the file has its lengths, such as "inch"
  std::string Note;                  ///< what of the file is left out; may be empty
};

/**
 * Read a file, whose kind is told by its extension: .step, .stp, .iges, .igs or .brep. Case does not count. Lengths of
 * BREP, which has no unit, are taken for millimetres.
 * @throws  CadError if it cannot be read
 */
CadFile ReadCadFile(const std::filesystem::path& file, ProgressLines& progress);

}
#endif
