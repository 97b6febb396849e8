/**
 * The build that measures.
 */
#ifndef VITRINE_BUILD_H
#define VITRINE_BUILD_H

#include "report/Json.h"

namespace program
{

/**
 * Returns {"vtk": its version, "program", "library": hashes of the files that run}. The hashes differ between builds of
 * one version, since figures of another build are not comparable. The files are read once per run.
 */
Json BuildJson();

}
#endif
