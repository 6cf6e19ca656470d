// soms-import .EXTENSION: reads a model from standard input by Assimp, as a file with that
// extension, and writes it to standard output. Exit status 1: it cannot be read, and standard
// output says why; 4: too little memory; 5: it cannot be written.
#include "apps/import/model.h"
#include "apps/import/sandbox.h"

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>

namespace soms::import_program {

namespace {

/// The model and nothing else: what a model names beside itself is not there.
class OneFile final : public Assimp::IOSystem {
 public:
  OneFile(std::string name, const std::uint8_t* bytes, std::size_t size)
      : name_(std::move(name)), bytes_(bytes), size_(size) {}

  [[nodiscard]] bool Exists(const char* file) const override { return name_ == file; }

  [[nodiscard]] char getOsSeparator() const override { return '/'; }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return Exists(file) && *mode == 'r' ? new Assimp::MemoryIOStream(bytes_, size_) : nullptr;
  }

  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string name_;
  const std::uint8_t* bytes_;
  std::size_t size_;
};

int refuse(const char* why) {
  std::fputs(why, stdout);
  return 1;
}

int import(const std::string& extension) {
  struct stat status {};

  if (fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) {
    return refuse("standard input is not a file, or is empty");
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  const void* bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, STDIN_FILENO, 0);
  if (bytes == MAP_FAILED) {
    return 4;
  }
  // From here on the content of the file is in control, as far as the sandbox lets it.
  close(STDIN_FILENO);
  const std::string unguarded = enter_sandbox();
  const std::string name = "model" + extension;
  Assimp::Importer importer;
  importer.SetIOHandler(new OneFile(name, static_cast<const std::uint8_t*>(bytes), size));
  const aiScene* scene = importer.ReadFile(name, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string why = importer.GetErrorString();
    return why.find("bad_alloc") == std::string::npos ? refuse(why.c_str()) : 4;
  }
  Answer answer;
  write_scene(*scene, extension, answer);
  if (!unguarded.empty()) {
    answer.note("soms-import ran without its sandbox (" + unguarded +
                "): a malicious file could have run code with your permissions; read untrusted "
                "files in a container");
  }
  return answer.finish() ? 0 : 5;
}

}  // namespace

}  // namespace soms::import_program

int main(int count, char** words) {
  // The caller is gone: so is the question.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (count != 2 || *words[1] != '.') {
    std::fputs(
        "soms-import .EXTENSION < MODEL: a helper program, which soms starts when it needs it\n",
        stdout);
    return 2;
  }
  try {
    return soms::import_program::import(words[1]);
  } catch (const std::bad_alloc&) {
    return 4;
  } catch (const std::exception& error) {
    return soms::import_program::refuse(error.what());
  }
}
