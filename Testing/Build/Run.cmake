# run(COMMAND...): run a command; where it fails, so does the test, and its output is shown.
function (run)
  execute_process(
    COMMAND         ${ARGN}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE output
    ERROR_VARIABLE  output)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\nfailed (${result}):\n${output}")
  endif ()
endfunction ()
