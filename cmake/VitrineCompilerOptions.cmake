# Warnings and sanitizers for every target of the stand-alone build.
add_compile_options(-Wall -Wextra)
if (VITRINE_SANITIZE)
  add_compile_options(-fsanitize=${VITRINE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VITRINE_SANITIZE})
endif ()
