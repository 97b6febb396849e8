/**
 * The build that measures.
 */
#ifndef VITRINE_BUILD_H
#define VITRINE_BUILD_H

#include "report/Json.h"

namespace program
{

/**
 * {"vtk": its version, "program", "library": hashes of the files that run}, which differ between builds of one version: figures
 * of another build are not this one's. The
 * files are read once a run.
 */
Json BuildJson();

}
#endif
