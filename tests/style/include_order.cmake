cmake_minimum_required(VERSION 3.25)

#Fails where a folder of ROOT includes from one that comes after it : the list
#of folders is the order of the algorithm.
include(${ROOT}/cmake/folders.cmake)
set(order ${rift_folders})

foreach(folder ${order})
  list(APPEND allowed ${folder})
  file(GLOB_RECURSE files RELATIVE ${ROOT}
    ${ROOT}/include/rift/${folder}/*.h ${ROOT}/source/${folder}/*.cc)
  list(LENGTH files n_files)
  if(n_files EQUAL 0)
    message(SEND_ERROR "there are no files of the folder ${folder}")
  endif()
  foreach(file ${files})
    file(STRINGS ${ROOT}/${file} includes REGEX "^ *# *include *[<\"]rift/")
    foreach(include ${includes})
      string(REGEX REPLACE ".*[<\"]rift/([^/]*)/.*" "\\1" from "${include}")
      if(NOT from IN_LIST allowed)
        message(SEND_ERROR "${file}: ${include}, but ${folder} comes before "
          "${from}")
      endif()
    endforeach()
  endforeach()
endforeach()

# A folder that is not in the list could include anything.
file(GLOB folders RELATIVE ${ROOT}/include/rift ${ROOT}/include/rift/*)
foreach(folder ${folders})
  if(NOT folder IN_LIST order)
    message(SEND_ERROR "include/rift/${folder} is not in the order of folders")
  endif()
endforeach()
