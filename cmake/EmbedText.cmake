# Encode a text file as a C++ string.
#
#   cmake -DINPUT=x.css -DOUTPUT=x.css.cxx -DSYMBOL=x -DNAMESPACE=n -P EmbedText.cmake
include("${CMAKE_CURRENT_LIST_DIR}/StringLiterals.cmake")
file(READ "${INPUT}" text)
vitrine_literals(literals "text" "${text}")
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
// Written by EmbedText.cmake.
namespace @NAMESPACE@
{
extern const char* const @SYMBOL@;
const char* const @SYMBOL@ = @literals@;
}
]])
