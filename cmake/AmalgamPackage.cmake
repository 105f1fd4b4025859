# What a Debian package holds besides the programs: the service's unit, a configuration, man pages. deploy/package.sh
# makes the package.

set(AMALGAM_PROGRAMS amalgam-server amalgam-client amalgam-render amalgam-inspect amalgam-load amalgam-marker)
add_custom_target(amalgam_installed DEPENDS ${AMALGAM_PROGRAMS})

# Man pages say what --help says.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  set(descriptions
    "amalgam-server=mixed-reality rendering server"
    "amalgam-client=shows virtual objects in a camera's picture"
    "amalgam-render=renders one mixed-reality frame without a network"
    "amalgam-inspect=lists a scene's contents and what its frames leave out"
    "amalgam-load=puts scripted load on an amalgam-server"
    "amalgam-marker=writes a page of markers to print")
  foreach(entry ${descriptions})
    string(REGEX MATCH "^([^=]+)=(.*)$" ignored ${entry})
    set(program ${CMAKE_MATCH_1})
    set(about ${CMAKE_MATCH_2})
    set(page ${PROJECT_BINARY_DIR}/man/${program}.1.gz)
    add_custom_command(OUTPUT ${page}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
      COMMAND ${HELP2MAN} --no-info --version-string=${PROJECT_VERSION} --name=${about}
              --output=${PROJECT_BINARY_DIR}/man/${program}.1 $<TARGET_FILE:${program}>
      COMMAND sed -i "s:${PROJECT_SOURCE_DIR}/deploy/scenes:/usr/share/amalgam/scenes:" ${PROJECT_BINARY_DIR}/man/${program}.1
      COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/man/${program}.1
      DEPENDS ${program} VERBATIM)
    list(APPEND pages ${page})
  endforeach()
  add_custom_target(amalgam_man_pages ALL DEPENDS ${pages})
  add_dependencies(amalgam_installed amalgam_man_pages)
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endif()

set(debian ${PROJECT_SOURCE_DIR}/deploy/debian)
install(FILES deploy/systemd/amalgam.service DESTINATION lib/systemd/system)
# The package moves it from /usr/etc to where the unit looks for it.
install(FILES deploy/systemd/server.toml DESTINATION etc/amalgam)
file(WRITE ${PROJECT_BINARY_DIR}/move_etc.cmake
  "file(RENAME \${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/etc \${CPACK_TEMPORARY_INSTALL_DIRECTORY}/etc)\n")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_BINARY_DIR}/move_etc.cmake)
install(DIRECTORY deploy/haproxy deploy/prometheus deploy/grafana deploy/kubernetes
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(FILES deploy/SCALING.md ${debian}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Debian's own form of it, which names the maintainer; CHANGELOG.md is what people read.
set(AMALGAM_MAINTAINER "Amalgam's authors <amalgam@example.org>" CACHE STRING "Who answers for the Debian package")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/changelog "amalgam (${PROJECT_VERSION}) unstable; urgency=medium

  * See NEWS.

 -- ${AMALGAM_MAINTAINER}  ${now}
")
foreach(file ${PROJECT_BINARY_DIR}/changelog ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
  get_filename_component(name ${file} NAME_WE)
  string(REPLACE "CHANGELOG" "NEWS" name ${name})
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${PROJECT_BINARY_DIR}/${name}.gz)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/changelog.gz ${PROJECT_BINARY_DIR}/NEWS.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME amalgam)
set(CPACK_PACKAGE_CONTACT ${AMALGAM_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "mixed-reality rendering server and its tools
Puts virtual glass, mirrors and colored objects into a camera's picture:
clients send camera frames and poses of markers, the server ray-traces
what is mirrored or refracted, rasterises the rest and sends the
composite back. It needs no GPU.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded while it runs: Mesa's llvmpipe. adduser makes the service's user.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "adduser, libgl1-mesa-dri, libegl1")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
file(WRITE ${PROJECT_BINARY_DIR}/conffiles "/etc/amalgam/server.toml\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  ${debian}/postinst ${debian}/prerm ${debian}/postrm ${PROJECT_BINARY_DIR}/conffiles)
include(CPack)
