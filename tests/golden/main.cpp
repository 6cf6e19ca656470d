// golden DATA [N...]: compares every row with DATA/../golden/answers.csv, for each number of
// threads N, or for 1, 2 and 8. golden DATA modes: the same with each setting of the processor that
// a host program may choose. golden DATA write: prints the rows, for answers.csv. The exit status
// is 77 where SOMS_ISA names what this processor does not offer.
#include "soms/base/error.h"

#include "tests/golden/golden.h"
#include "tests/support/host_arithmetic.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace soms::golden {
namespace {

Rows expected_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  Rows rows;
  std::string line;
  std::getline(in, line);  // the header
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    const std::string name = line.substr(0, comma);
    if (!name.ends_with(".dae") || reads_collada()) {
      rows[name] = std::stoull(line.substr(comma + 1), nullptr, 16);
    }
  }
  if (rows.empty()) {
    throw std::runtime_error(file.string() + " holds no rows");
  }
  return rows;
}

/// Number of rows that differ; each is reported.
int differences(const Rows& expected, const Rows& rows, const std::string& setting) {
  int count = 0;
  for (const auto& [name, hash] : rows) {
    const auto found = expected.find(name);
    if (found == expected.end() || found->second != hash) {
      std::printf("%s: %s is another\n", setting.c_str(), name.c_str());
      ++count;
    }
  }
  if (rows.size() != expected.size()) {
    std::printf("%s: %zu rows in place of %zu\n", setting.c_str(), rows.size(), expected.size());
    ++count;
  }
  return count;
}

/// The status of the program.
int conclude(const Rows& expected, std::size_t settings, int count) {
  std::printf("%zu rows, %zu settings, %d differences\n", expected.size(), settings, count);
  return count == 0 ? 0 : 1;
}

int compare_modes(const Inputs& inputs, const Rows& expected) {
  int count = 0;
  for (const test::HostMode& mode : test::host_modes()) {
    const auto rows = [&] {
      const test::HostArithmetic host(mode);
      return all_rows(inputs, 2);
    }();
    count += differences(expected, rows, std::string(mode.name));
  }
  return conclude(expected, test::host_modes().size(), count);
}

int compare_threads(const Inputs& inputs, const Rows& expected, const std::vector<int>& numbers) {
  int count = 0;
  for (const int threads : numbers) {
    count += differences(expected, all_rows(inputs, threads), std::to_string(threads) + " threads");
  }
  return conclude(expected, numbers.size(), count);
}

int run(const std::string& data, const std::vector<std::string>& rest) {
  const Inputs inputs(data);
  const std::string what = rest.empty() ? "" : rest.front();
  if (what == "write") {
    std::printf("what,hash\n");
    for (const auto& [name, hash] : all_rows(inputs, 1)) {
      std::printf("%s,%016llx\n", name.c_str(), static_cast<unsigned long long>(hash));
    }
    return 0;
  }
  const Rows expected = expected_rows(inputs.data.parent_path() / "golden" / "answers.csv");
  if (what == "modes") {
    return compare_modes(inputs, expected);
  }
  std::vector<int> numbers;
  for (const std::string& number : rest) {
    numbers.push_back(std::stoi(number));
  }
  return compare_threads(inputs, expected, numbers.empty() ? std::vector{1, 2, 8} : numbers);
}

}  // namespace
}  // namespace soms::golden

int main(int argc, char** argv) {
  constexpr int kSkipped = 77;
  try {
    return soms::golden::run(argc > 1 ? argv[1] : "", {argv + std::min(argc, 2), argv + argc});
  } catch (const soms::Error& error) {
    std::cerr << "golden: " << error.what() << '\n';
    return error.kind() == soms::ErrorKind::unsupported ? kSkipped : 2;
  } catch (const std::exception& error) {
    std::cerr << "golden: " << error.what() << '\n';
    return 2;
  }
}
