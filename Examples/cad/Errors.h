/**
 * How the converter fails.
 */
#ifndef VITRINE_CAD_ERRORS_H
#define VITRINE_CAD_ERRORS_H

#include <stdexcept>

namespace cad
{

/** A file that cannot be read or written. what() says why in one line, without the file's name. */
class CadError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}
#endif
