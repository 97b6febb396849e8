/**
 * How files are read that allow of several ways.
 */
#ifndef VITRINE_READING_OPTIONS_H
#define VITRINE_READING_OPTIONS_H

namespace program
{

/** Of STEP, IGES and BREP. */
struct ReadingOptions
{
  double Tolerance = 0.0; ///< metres that triangles may be from the shapes; 0 for a default by size
  bool UseCache = true;   ///< of triangles that were made before
};

}
#endif
