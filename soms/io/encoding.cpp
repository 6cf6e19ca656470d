#include "soms/io/encoding.h"

#include "soms/base/error.h"

namespace soms {

void refuse_utf16(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    throw Error(ErrorKind::unsupported, name + ": text in UTF-16", "save it as ASCII or UTF-8");
  }
}

}  // namespace soms
