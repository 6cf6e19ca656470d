#include "thesis/program/print_pdf.h"

#include "soms/base/error.h"

#include "apps/cli/child.h"
#include "apps/cli/temporary_folder.h"
#include "apps/cli/text.h"
#include "thesis/page/paper.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

/// Bytes of what Chromium said that an error shows: its last lines tell what went wrong.
constexpr std::size_t kShownBytes = 400;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

Error failed(const fs::path& chromium, const std::string& how, const std::string& said) {
  const std::size_t cut = said.size() - std::min(said.size(), kShownBytes);
  return Error(ErrorKind::unsupported,
               fmt::format("--pdf: {} {}{}", chromium.string(), how,
                           said.empty() ? "" : ": " + printable(said.substr(cut))),
               "set SOMS_CHROMIUM to another Chromium, or print index.html from a browser");
}

}  // namespace

fs::path find_chromium() {
  std::vector<std::string> names = reproduce::chromium_names();
  const std::string first = names.front();
  names.erase(names.begin());
  return find_program({.name = first,
                       .variable = "SOMS_CHROMIUM",
                       .remedy =
                           "--pdf needs Chromium or Chrome: install it (Debian: chromium), set "
                           "SOMS_CHROMIUM to its path, or print index.html from a browser",
                       .other_names = names});
}

std::string printed_pdf(const fs::path& chromium, std::string_view html, const Console& console) {
  const TemporaryFolder folder("folder for the PDF");
  const reproduce::PrintJob job{.page = folder.path() / "page.html",
                                .pdf = folder.path() / "page.pdf",
                                .profile = folder.path() / "profile",
                                .as_root = ::geteuid() == 0};
  std::ofstream(job.page, std::ios::binary) << html;
  std::error_code unknown;
  if (fs::file_size(job.page, unknown) != html.size()) {
    throw Error(ErrorKind::cannot_write,
                fmt::format("--pdf: the page does not fit into {}", folder.path().string()),
                "set TMPDIR to a folder with free space");
  }
  const Progress bar = console.progress("printing");
  const int status =
      run_child(chromium, reproduce::chromium_words(job), console, {.home = folder.path()});
  const std::string said = bytes_of(folder.path() / "said");
  if (status != 0) {
    throw failed(chromium, fmt::format("ended with status {}", status), said);
  }
  std::string pdf = bytes_of(job.pdf);
  if (!pdf.starts_with("%PDF-")) {
    throw failed(chromium, "wrote no PDF", said);
  }
  return pdf;
}

}  // namespace soms::command
