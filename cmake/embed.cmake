# Writes a C++ source with the bytes of a file:
#   cmake -D FILE=... -D OUT=... -D HEADER=... -D FUNCTION=a::b::c -P embed.cmake
# HEADER declares the function, which returns a std::string_view.
file(READ "${FILE}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
file(WRITE "${OUT}" "// Made by cmake/embed.cmake.
#include \"${HEADER}\"

std::string_view ${FUNCTION}() {
  static constexpr char kBytes[] = \"${bytes}\";
  return {kBytes, sizeof kBytes - 1};
}
")
