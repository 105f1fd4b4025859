# Runs deploy/scenes/generate_scenes.py into OUTPUT and compares every file with the committed one.
# All of stiff/ is generated: what the generator no longer makes must not stay there.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${OUTPUT})
execute_process(COMMAND ${PYTHON} -B ${SCENES}/generate_scenes.py --output ${OUTPUT}
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE made RELATIVE ${OUTPUT} ${OUTPUT}/*)
list(LENGTH made count)
if(count LESS 80)
  message(FATAL_ERROR "only ${count} files were made")
endif()
foreach(name ${made})
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${OUTPUT}/${name} ${SCENES}/${name}
    RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${name} differs from the committed one: run generate_scenes.py")
  endif()
endforeach()
file(GLOB committed RELATIVE ${SCENES} ${SCENES}/stiff/*)
foreach(name ${committed})
  if(NOT name IN_LIST made)
    message(FATAL_ERROR "${name} is not made by generate_scenes.py")
  endif()
endforeach()
