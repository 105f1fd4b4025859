# Run at build time: cmake -DFOLDER=dist -DNAME=web_files -DOUTPUT=x.cpp -P embed_web.cmake
# Writes the table of a page's files, which the function NAME returns. The assembler takes in their bytes, which a
# compiler would chew on for minutes.

file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT files)
set(symbols "")
set(entries "")
set(count 0)
foreach(file ${files})
  if(file MATCHES "[^A-Za-z0-9._/-]")
    message(FATAL_ERROR "${FOLDER}/${file}: only letters, digits and . _ - may be in a name of the page")
  endif()
  set(symbol amalgam_${NAME}_${count})
  # Here and not at each request.
  file(SHA256 ${FOLDER}/${file} digest)
  string(SUBSTRING ${digest} 0 32 tag)
  string(APPEND symbols "asm(\".section .rodata\\n.global ${symbol}, ${symbol}_end\\n${symbol}:\\n\"
    \".incbin \\\"${FOLDER}/${file}\\\"\\n${symbol}_end:\\n.byte 0\\n.text\\n\");
extern \"C\" const char ${symbol}, ${symbol}_end;
")
  string(APPEND entries "    entry(\"${file}\", \"\\\"${tag}\\\"\", &${symbol}, &${symbol}_end),\n")
  math(EXPR count "${count} + 1")
endforeach()

if(count EQUAL 0)
  set(body "  return {};\n")
else()
  set(body "  static const std::array<WebFile, ${count}> kFiles{\n${entries}  };\n  return kFiles;\n")
endif()
file(WRITE ${OUTPUT} "// Made by embed_web.cmake.
#include \"web/web_files.h\"

#include <array>

#include \"web/content_type.h\"

${symbols}
namespace amalgam::web {
namespace {

[[maybe_unused]] WebFile entry(std::string_view path, std::string_view tag, const char* begin,
                               const char* end) {
  return {path, content_type(path), {begin, static_cast<std::size_t>(end - begin)}, tag};
}

}  // namespace

std::span<const WebFile> ${NAME}() {
${body}}

}  // namespace amalgam::web
")
