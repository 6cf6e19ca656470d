// What code that a model smuggled into soms-import would try, in a process that entered the same
// sandbox. No framework: it must run where nearly every system call fails.
//
//   import_attempt NAME          tries it in the sandbox: status 0 if it worked, 1 if it failed
//   with
//                                EPERM, 2 if otherwise
//   import_attempt NAME bare     the same without the sandbox
//   import_attempt calls         names, by number, every system call that does not fail with EPERM
//   import_attempt names         the attempts
//   import_attempt without-seccomp PROGRAM [ARGUMENT...]
//                                runs a program that the kernel allows no filter of its own
#include "apps/import/sandbox.h"

#include <fcntl.h>
#include <linux/prctl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

/// What is open before the sandbox closes, as a library might have left it open.
struct Opened {
  Opened() { ready = socketpair(AF_UNIX, SOCK_STREAM, 0, sockets.data()) == 0; }

  bool ready = false;
  int file = open("opened", O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  std::array<int, 2> sockets{-1, -1};
  int server = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int client = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
};

/// Opened by the first call, in the current folder.
const Opened& opened() {
  static const Opened files;
  return files;
}

/// In the child of a fork: nothing to do.
long ended(long child) {
  if (child == 0) {
    _exit(0);
  }
  if (child > 0) {
    waitpid(static_cast<pid_t>(child), nullptr, 0);
  }
  return child;
}

long run_true() {
  const std::array<const char*, 2> words = {"/bin/true", nullptr};
  return execve(words[0], const_cast<char* const*>(words.data()), environ);
}

long mapped(void* place) {
  return place == MAP_FAILED ? -1 : 0;
}

sockaddr_un address_of_server() {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, "listening");
  return address;
}

long connect_to_server() {
  const sockaddr_un address = address_of_server();
  return connect(opened().client, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

/// False if what the attempts need could not be made.
bool prepare() {
  const sockaddr_un address = address_of_server();
  return opened().file >= 0 && ftruncate(opened().file, 4096) == 0 && mapped(opened().page) == 0 &&
         opened().ready &&
         bind(opened().server, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
         listen(opened().server, 1) == 0;
}

long change_memory(long call, pid_t process) {
  static int from = 1;
  static int to = 0;
  const iovec here{&from, sizeof from};
  const iovec there{&to, sizeof to};
  return syscall(call, process, &here, 1, &there, 1, 0);
}

long limit_of_parent() {
  rlimit limit{};
  return prlimit(getppid(), RLIMIT_NOFILE, nullptr, &limit);
}

struct Attempt {
  std::string_view name;
  long (*act)();  ///< negative where it failed
};

constexpr auto kAttempts = std::to_array<Attempt>({
    // Files.
    {"open-to-read", [] { return long{open("/etc/passwd", O_RDONLY)}; }},
    {"open-to-write", [] { return long{open("victim", O_WRONLY)}; }},
    {"create", [] { return long{open("created", O_WRONLY | O_CREAT, 0600)}; }},
    {"openat", [] { return long{openat(AT_FDCWD, "victim", O_RDWR)}; }},
    {"memory-of-itself", [] { return long{open("/proc/self/mem", O_RDWR)}; }},
    {"write-to-an-open-file", [] { return long{write(opened().file, "x", 1)}; }},
    {"read-of-an-open-file", [] { return long{read(opened().file, opened().page, 1)}; }},
    {"grow-an-open-file", [] { return long{ftruncate(opened().file, 9)}; }},
    {"memory-file", [] { return long{memfd_create("x", 0)}; }},
    {"unlink", [] { return long{unlink("victim")}; }},
    {"rename", [] { return long{rename("victim", "renamed")}; }},
    {"link", [] { return long{link("victim", "linked")}; }},
    {"symlink", [] { return long{symlink("/", "link")}; }},
    {"make-folder", [] { return long{mkdir("folder", 0700)}; }},
    {"permissions", [] { return long{chmod("victim", 0777)}; }},
    {"truncate", [] { return long{truncate("victim", 0)}; }},
    {"move-to-a-folder", [] { return long{chdir("/")}; }},
    {"stat",
     [] {
       struct stat status {};
       return long{stat("/etc/passwd", &status)};
     }},
    // Programs and processes.
    {"execute", run_true},
    {"fork", [] { return ended(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0)); }},
    {"fork-by-libc", [] { return ended(fork()); }},
    {"signal-to-the-parent", [] { return long{kill(getppid(), 0)}; }},
    {"thread-signal-to-the-parent", [] { return syscall(SYS_tgkill, getppid(), getppid(), 0); }},
    {"trace", [] { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr); }},
    {"write-to-a-process", [] { return change_memory(SYS_process_vm_writev, getpid()); }},
    {"read-of-a-process", [] { return change_memory(SYS_process_vm_readv, getpid()); }},
    {"limits-of-the-parent", limit_of_parent},
    {"outlive-the-parent", [] { return long{prctl(PR_SET_PDEATHSIG, 0)}; }},
    // Network.
    {"socket", [] { return long{socket(AF_INET, SOCK_STREAM, 0)}; }},
    {"socket-of-packets", [] { return long{socket(AF_INET6, SOCK_DGRAM, 0)}; }},
    {"connect", connect_to_server},
    {"send", [] { return long{send(opened().sockets[0], "x", 1, 0)}; }},
    {"write-to-a-socket", [] { return long{write(opened().sockets[0], "x", 1)}; }},
    // Memory that could hold a program.
    {"map-executable-memory",
     [] {
       return mapped(mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                          MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
     }},
    {"make-memory-executable",
     [] { return long{mprotect(opened().page, 4096, PROT_READ | PROT_EXEC)}; }},
    {"map-a-file",
     [] { return mapped(mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE, opened().file, 0)); }},
    // The kernel's larger doors. Without the sandbox some need a right or an option of the kernel.
    {"privileged-io-uring", [] { return syscall(SYS_io_uring_setup, 1, opened().page); }},
    {"privileged-mount", [] { return long{mount("none", ".", "tmpfs", 0, nullptr)}; }},
    {"privileged-namespace", [] { return long{unshare(CLONE_NEWUSER)}; }},
    {"privileged-bpf", [] { return syscall(SYS_bpf, 0, opened().page, 64); }},
    {"privileged-user-fault", [] { return syscall(SYS_userfaultfd, 0); }},
    {"privileged-key", [] { return syscall(SYS_add_key, "user", "soms", "x", 1, -1); }},
});

#ifdef __x86_64__
/// getpid by the table of 32-bit x86, of x32: what the filter must not take for another call.
long call_of_i386() {
  long result = 20;
  __asm__ volatile("int $0x80" : "+a"(result) : : "memory", "r8", "r9", "r10", "r11");
  return result;
}

long call_of_x32() {
  return syscall(0x40000000 | SYS_getpid);
}

constexpr auto kForeign = std::to_array<Attempt>({
    {"foreign-i386", call_of_i386},
    {"foreign-x32", call_of_x32},
});
#else
constexpr std::array<Attempt, 0> kForeign{};
#endif

/// Ends the process, so that it cannot be tried and reported.
bool ends_all(long call) {
  return call == SYS_exit || call == SYS_exit_group || call == SYS_rt_sigreturn;
}

/// uretprobe and uprobe: since Linux 6.11 they pass every filter, and end whoever calls them from
/// elsewhere than a probe of the kernel (SIGILL).
bool is_of_probes(long call) {
#ifdef __x86_64__
  return call == 335 || call == 336;
#else
  static_cast<void>(call);
  return false;
#endif
}

int name_calls() {
  // More than Linux 6 has on any architecture.
  for (long call = 0; call < 1024; ++call) {
    errno = 0;
    if (is_of_probes(call)) {
      continue;
    }
    if (ends_all(call) || syscall(call, -1L, -1L, -1L, -1L, -1L, -1L) != -1 || errno != EPERM) {
      std::printf("%ld\n", call);
    }
  }
  return std::fflush(stdout);
}

int try_out(const Attempt& attempt) {
  errno = 0;
  if (attempt.act() >= 0) {
    return 0;
  }
  const int code = errno;
  std::printf("%s\n", std::strerror(code));
  return code == EPERM ? 1 : 2;
}

/// As on a kernel that was built without filters.
int run_without_seccomp(char** words) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  const scmp_arg_cmp mode{0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0};
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(seccomp), 0);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1, mode);
  if (seccomp_load(filter) == 0) {
    execv(words[0], words);
  }
  return 3;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view name = count > 1 ? words[1] : "";
  if (name == "names") {
    for (const Attempt& attempt : kAttempts) {
      std::printf("%s\n", attempt.name.data());
    }
    for (const Attempt& attempt : kForeign) {
      std::printf("%s\n", attempt.name.data());
    }
    return 0;
  }
  if (name == "without-seccomp" && count > 2) {
    return run_without_seccomp(words + 2);
  }
  const bool bare = count > 2 && std::string_view(words[2]) == "bare";
  if (!prepare() || (!bare && !soms::import_program::enter_sandbox().empty())) {
    return 3;
  }
  if (name == "calls") {
    return name_calls();
  }
  for (const Attempt& attempt : kAttempts) {
    if (attempt.name == name) {
      return try_out(attempt);
    }
  }
  for (const Attempt& attempt : kForeign) {
    if (attempt.name == name) {
      return try_out(attempt);
    }
  }
  return 3;
}
