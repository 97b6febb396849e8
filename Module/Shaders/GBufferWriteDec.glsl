// Declarations for mappers' fragment shaders that write the G-buffer.
#include "SharedLayout.h"
