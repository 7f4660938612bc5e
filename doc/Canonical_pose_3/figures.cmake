# Writes a sed script that numbers the figures of the given pages, in their order: \cgalFigureBegin receives the
# number as its second argument, and \cgalFigureRef becomes a link with the number.

function(number_figures script)
  set(number 0)
  set(sed_text "")
  foreach(page IN LISTS ARGN)
    file(READ ${page} text)
    string(REGEX MATCHALL "cgalFigureBegin{[^,]+," figures "${text}")
    foreach(figure IN LISTS figures)
      string(REGEX REPLACE "cgalFigureBegin{(.+)," "\\1" key "${figure}")
      math(EXPR number "${number} + 1")
      string(APPEND sed_text
        "s/\\\\cgalFigureBegin{${key},/\\\\cgalNumberedFigureBegin{${key},${number},/\n"
        "s/\\\\cgalFigureRef{${key}}/\\\\ref fig__${key} \"Figure ${number}\"/g\n")
    endforeach()
  endforeach()
  file(WRITE ${script} "${sed_text}")
endfunction()
