/// \file
/// How many fields an aggregate has, so that a list of them is known to be whole.
#pragma once

#include <cstddef>
#include <type_traits>

namespace soms {

/// Fields of an aggregate, by how many pairs of braces it takes; its base class is one. 18 for more
/// than 17.
template <class T>
[[nodiscard]] consteval std::size_t field_count() {
  static_assert(std::is_aggregate_v<T>, "only an aggregate shows its fields");
  // clang-format off
  if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 18; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 17; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 16; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 15; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 14; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 13; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 12; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 11; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 10; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}}; }) { return 9; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}}; }) { return 8; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}}; }) { return 7; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}, {}}; }) { return 6; }
  else if constexpr (requires { T{{}, {}, {}, {}, {}}; }) { return 5; }
  else if constexpr (requires { T{{}, {}, {}, {}}; }) { return 4; }
  else if constexpr (requires { T{{}, {}, {}}; }) { return 3; }
  else if constexpr (requires { T{{}, {}}; }) { return 2; }
  else if constexpr (requires { T{{}}; }) { return 1; }
  else { return 0; }
  // clang-format on
}

}  // namespace soms
