# SPDX-License-Identifier: LGPL-2.1-or-later
# The headers that users include, and what these include in turn: only they are installed and have
# pages. Users' are those that lie in the folder of core or of an adapter itself, and in the rooms of
# core that hold the forms and what is done with one form.
cmake_policy(VERSION 3.25) # scripts that install have none
set(BLOSSOM_ROOMS_OF_USERS core/blossom core/forms core/forms/algebra core/papers core/subdivision)

# source    the project's folder
# folders   core, adapters/occt, ...: those of the parts that there are
# result    gets the names, from the project's folder on
function(blossom_public_headers source folders result)
  if("core" IN_LIST folders)
    list(APPEND folders ${BLOSSOM_ROOMS_OF_USERS})
  endif()
  list(TRANSFORM folders PREPEND "${source}/")
  list(TRANSFORM folders APPEND "/*.h")
  file(GLOB waiting RELATIVE ${source} ${folders})
  set(found)
  while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST found OR NOT EXISTS ${source}/${header})
      continue()
    endif()
    list(APPEND found ${header})
    file(STRINGS ${source}/${header} included REGEX "^#include \"")
    list(TRANSFORM included REPLACE "^#include \"([^\"]+)\".*" "\\1")
    list(APPEND waiting ${included})
  endwhile()
  list(SORT found)
  set(${result} ${found} PARENT_SCOPE)
endfunction()
