// What shaders that write the G-buffer know of it.
#include "SharedLayout.h"
