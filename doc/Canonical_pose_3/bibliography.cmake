# Makes of bibliography.bib a page of the manual, and a sed script that turns \cgalCite{key} into a link to
# it: no BibTeX, hence no TeX, is needed. A key without an entry stays an unknown command, on which
# doxygen warns.
#
# Each field of an entry stands on a line of its own; "shorthand" is the text of the link.

function(make_bibliography bib page citations)
  file(READ ${bib} text)
  string(REPLACE "\\&" "&amp;" text "${text}")
  string(REPLACE "--" "&ndash;" text "${text}")
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REGEX MATCHALL "@[a-z]+{[^@]+" entries "${text}")
  set(page_text "/*!\n\\page Canonical_pose_3_bibliography Bibliography\n")
  set(sed_text "")
  foreach(entry IN LISTS entries)
    string(REGEX MATCH "^@[a-z]+{([^,]+)," key "${entry}")
    set(key ${CMAKE_MATCH_1})
    string(MAKE_C_IDENTIFIER ${key} anchor)
    foreach(field IN ITEMS
        author title journal booktitle institution school volume pages year doi shorthand)
      set(${field} "")
      if(entry MATCHES "\n *${field} = {([^\n]*)}")
        set(${field} "${CMAKE_MATCH_1}")
      endif()
    endforeach()
    string(REPLACE " and " ", " author "${author}")
    string(APPEND page_text
      "\\anchor cite_${anchor} <b>[${shorthand}]</b> ${author}. <em>${title}</em>. "
      "${journal}${booktitle}${institution}${school}")
    if(volume)
      string(APPEND page_text " ${volume}")
    endif()
    if(pages)
      string(APPEND page_text ", pages ${pages}")
    endif()
    string(APPEND page_text ", ${year}.")
    if(doi)
      string(APPEND page_text " <a href=\"https://doi.org/${doi}\">doi:${doi}</a>")
    endif()
    string(APPEND page_text "\n\n")
    string(APPEND sed_text
      "s/\\\\cgalCite{${key}}/[\\\\ref cite_${anchor} \"${shorthand}\"]/g\n")
  endforeach()
  string(APPEND page_text "*/\n")
  string(REPLACE "<semicolon>" ";" page_text "${page_text}")
  file(WRITE ${page} "${page_text}")
  file(WRITE ${citations} "${sed_text}")
endfunction()
