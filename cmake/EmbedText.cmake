# Encode a text file as a C++ string.
#
#   cmake -DINPUT=x.css -DOUTPUT=x.css.cxx -DSYMBOL=x -DNAMESPACE=n -P EmbedText.cmake
#
# A raw string literal may hold 64 KiB at most in portable compilers.
file(READ "${INPUT}" text)
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
// Written by EmbedText.cmake.
namespace @NAMESPACE@
{
extern const char* const @SYMBOL@;
const char* const @SYMBOL@ = R"text(@text@)text";
}
]])
