#include "apps/import/sandbox.h"

#ifdef SOMS_SECCOMP
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#endif

namespace soms::import_program {

#ifdef SOMS_SECCOMP

namespace {

/// Allowed whatever their arguments. Some exist on some architectures only; others have a second
/// number where the first one's time has 32 bits. What a C library newer than this list calls
/// beyond it fails, which it must be ready for: such calls fail in containers too.
constexpr auto kAllowed = std::to_array<int>({
    // Memory. What may be mapped and made executable is checked below.
    SCMP_SYS(brk),
    SCMP_SYS(madvise),
    SCMP_SYS(mremap),
    SCMP_SYS(munmap),
    // Locks, clocks, random numbers, and how large this machine is.
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_gettime64),
    SCMP_SYS(futex),
    SCMP_SYS(futex_time64),
    SCMP_SYS(getpid),
    SCMP_SYS(getrandom),
    SCMP_SYS(gettid),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(sched_getaffinity),
    SCMP_SYS(sched_yield),
    SCMP_SYS(sysinfo),
    SCMP_SYS(time),
    // Its own signals, abort() among them, and the end.
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigreturn),
});

/// The lower half of an argument, all that the kernel reads of a descriptor or a process number.
scmp_arg_cmp equals(unsigned argument, int value) {
  return {argument, SCMP_CMP_MASKED_EQ, 0xffffffffU, static_cast<std::uint32_t>(value)};
}

/// Bits of `mask` in an argument, which must be those of `value`.
scmp_arg_cmp bits(unsigned argument, int mask, int value) {
  return {argument, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(mask),
          static_cast<scmp_datum_t>(value)};
}

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release) {
    if (context_ == nullptr) {
      fault_ = -ENOMEM;
      return;
    }
    note(seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
    // So that a refusal of the kernel says which.
    note(seccomp_attr_set(context_.get(), SCMP_FLTATR_API_SYSRAWRC, 1));
  }

  /// Allows a system call whose arguments pass every check. One that this architecture does not
  /// have is passed over.
  void allow(int call, std::initializer_list<scmp_arg_cmp> checks = {}) {
    if (fault_ == 0) {
      note(seccomp_rule_add_array(context_.get(), SCMP_ACT_ALLOW, call,
                                  static_cast<unsigned>(checks.size()), checks.begin()));
    }
  }

  /// Puts it into force. 0, or an error number.
  [[nodiscard]] int load() {
    if (fault_ == 0) {
      note(seccomp_load(context_.get()));
    }
    return -fault_;
  }

 private:
  void note(int result) { fault_ = fault_ == 0 && result < 0 ? result : fault_; }

  std::unique_ptr<void, decltype(&seccomp_release)> context_;
  int fault_ = 0;  ///< the first one, negative
};

}  // namespace

std::string enter_sandbox() {
  Filter filter;
  for (const int call : kAllowed) {
    filter.allow(call);
  }
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mmap2)}) {
    filter.allow(call, {bits(2, PROT_EXEC, 0), bits(3, MAP_ANONYMOUS, MAP_ANONYMOUS)});
  }
  filter.allow(SCMP_SYS(mprotect), {bits(2, PROT_EXEC, 0)});
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    filter.allow(SCMP_SYS(write), {equals(0, stream)});
    filter.allow(SCMP_SYS(writev), {equals(0, stream)});
  }
  filter.allow(SCMP_SYS(tgkill), {equals(0, getpid())});
  const int fault = filter.load();
  return fault == 0 ? std::string()
                    : std::string("the kernel does not allow it: ") + std::strerror(fault);
}

#else

std::string enter_sandbox() {
  return "it was built without libseccomp";
}

#endif

}  // namespace soms::import_program
