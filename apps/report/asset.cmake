# Makes a C++ source of a text: pieces of at most 8,000 bytes, which every compiler accepts, as the function FUNCTION of
# asset.h.
file(READ ${ASSET} text)
if(text MATCHES "\\)asset\"")
  message(FATAL_ERROR "${ASSET} holds the end mark of our string literals")
endif()
string(LENGTH "${text}" length)
set(source "#include \"apps/report/asset.h\"\n\n#include <array>\n\nnamespace soms::report {\n\n")
string(APPEND source "namespace {\n\nusing namespace std::string_view_literals;\n\nconstexpr std::array kPieces{\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 piece)
  string(APPEND source "    R\"asset(${piece})asset\"sv,\n")
  math(EXPR at "${at} + 8000")
endwhile()
string(APPEND source "};\n\n}  // namespace\n\nstd::span<const std::string_view> ${FUNCTION}() {\n"
  "  return kPieces;\n}\n\n}  // namespace soms::report\n")
file(WRITE ${SOURCE} "${source}")
