# Run at build time: cmake -DNPM=npm -DFOLDER=folder -P install_packages.cmake
# Installs what the package-lock.json of that folder says, and explains itself if it cannot.
execute_process(
  COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "npm could not fetch the page's packages. Without a network, -DAMALGAM_WEB=OFF leaves the page out")
endif()
