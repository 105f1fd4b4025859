# Run at build time: cmake -DFILES=a;b -DOUTPUT=x.cpp -P embed_shaders.cmake
# Writes one string constant a shader file, with #include "name" lines replaced by that file's text.

function(read_shader path result)
  file(READ ${path} text)
  get_filename_component(folder ${path} DIRECTORY)
  while(text MATCHES "#include \"([a-z_]+\\.glsl)\"")
    set(name ${CMAKE_MATCH_1})
    file(READ ${folder}/${name} included)
    string(REPLACE "#include \"${name}\"\n" "${included}" text "${text}")
  endwhile()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(entries "")
foreach(path ${FILES})
  get_filename_component(name ${path} NAME)
  read_shader(${path} text)
  string(APPEND entries "      {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()

file(WRITE ${OUTPUT} "// Made by embed_shaders.cmake.
#include \"shaders/shader_sources.h\"

#include <map>

namespace amalgam::shaders {

std::string_view source(std::string_view file) {
  static const std::map<std::string_view, std::string_view> kSources = {
${entries}  };
  return kSources.at(file);
}

}  // namespace amalgam::shaders
")
