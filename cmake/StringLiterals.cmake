# vitrine_literals(OUT DELIMITER TEXT)
#
# Encode a text as adjacent raw string literals, which the compiler joins. MSVC takes at most 16,380 bytes in one
# literal (error C2026), and at most 65,535 in all of them together (C1091). A longer text is an error.
function (vitrine_literals out delimiter text)
  set(most_bytes_of_literal 16000)
  set(most_bytes 65534)
  string(LENGTH "${text}" length) # in bytes
  if (length GREATER most_bytes)
    message(FATAL_ERROR "${INPUT}: the text has ${length} bytes, but a string of MSVC holds ${most_bytes}")
  endif ()

  set(literals "\"\"")
  set(first 0)
  while (first LESS length)
    # Literals end with lines, so that none of them ends within a character of several bytes.
    string(SUBSTRING "${text}" ${first} ${most_bytes_of_literal} part)
    math(EXPR rest "${length} - ${first}")
    string(FIND "${part}" "\n" end_of_line REVERSE)
    math(EXPR size "${end_of_line} + 1")
    if (rest GREATER most_bytes_of_literal AND size GREATER 0)
      string(SUBSTRING "${part}" 0 ${size} part)
    endif ()
    string(APPEND literals "\nR\"${delimiter}(${part})${delimiter}\"")
    string(LENGTH "${part}" size)
    math(EXPR first "${first} + ${size}")
  endwhile ()
  set(${out} "${literals}" PARENT_SCOPE)
endfunction ()
