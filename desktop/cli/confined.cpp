#include "desktop/cli/confined.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace snug::desktop {
namespace {

// ---- what the program may not do -------------------------------------------------------------------------------

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;  // no filter
#endif

/// Calls that are refused: network, other processes, and whatever changes a file system.
constexpr std::array kRefused {
  SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_sendto, SYS_sendmsg, SYS_execveat, SYS_ptrace,
      SYS_process_vm_readv, SYS_process_vm_writev, SYS_kill, SYS_tkill, SYS_unlinkat, SYS_renameat2, SYS_mkdirat,
      SYS_linkat, SYS_symlinkat, SYS_mknodat, SYS_fchmod, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_truncate,
      SYS_ftruncate, SYS_utimensat, SYS_mount, SYS_umount2, SYS_chroot, SYS_setns, SYS_unshare, SYS_setxattr,
      SYS_lsetxattr, SYS_fsetxattr, SYS_bpf, SYS_keyctl, SYS_add_key, SYS_io_uring_setup, SYS_memfd_create,
      SYS_userfaultfd, SYS_perf_event_open, SYS_shmget, SYS_msgget, SYS_renameat, SYS_setpgid, SYS_setsid, SYS_clone3,
      SYS_pidfd_open,
#if defined(__x86_64__)  // the older calls, which others lack
      SYS_fork, SYS_vfork, SYS_unlink, SYS_rename, SYS_mkdir, SYS_rmdir, SYS_link, SYS_symlink, SYS_mknod, SYS_chmod,
      SYS_chown, SYS_lchown, SYS_creat, SYS_utime, SYS_utimes, SYS_futimesat,
#endif
};

/// The filter of its calls: a program for the kernel.
std::vector<sock_filter> filter() {
  constexpr auto kErrno = [](int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); };
  const auto load = [](std::size_t at) {
    return sock_filter(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at)));
  };
  const auto give = [](std::uint32_t what) { return sock_filter(BPF_STMT(BPF_RET | BPF_K, what)); };
  const auto equals = [](std::uint32_t value, std::uint8_t yes, std::uint8_t no) {
    return sock_filter(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, yes, no));
  };
  const auto has_bit = [](std::uint32_t bits, std::uint8_t yes, std::uint8_t no) {
    return sock_filter(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, yes, no));
  };
  const auto argument = [](std::size_t i) { return offsetof(seccomp_data, args) + 8 * i; };  // its lower half
  std::vector<sock_filter> code{load(offsetof(seccomp_data, arch)), equals(kArchitecture, 1, 0),
                                give(SECCOMP_RET_KILL_PROCESS), load(offsetof(seccomp_data, nr))};
#if defined(__x86_64__)
  code.insert(code.end(), {has_bit(0x40000000, 0, 1), give(SECCOMP_RET_KILL_PROCESS)});  // the x32 calls
#endif
  for (const auto call : kRefused) {
    // Without clone3 the C library calls clone, whose flags the filter can read.
    const std::uint32_t refusal = kErrno(call == SYS_clone3 ? ENOSYS : EPERM);
    code.insert(code.end(), {equals(static_cast<std::uint32_t>(call), 0, 1), give(refusal)});
  }
  // A file is opened to be read, and a clone is a thread.
  constexpr std::uint32_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
  code.insert(code.end(), {equals(SYS_openat, 0, 3), load(argument(2)), has_bit(kWriting, 0, 1), give(kErrno(EACCES)),
                           load(offsetof(seccomp_data, nr))});
#if defined(__x86_64__)
  code.insert(code.end(), {equals(SYS_open, 0, 3), load(argument(1)), has_bit(kWriting, 0, 1), give(kErrno(EACCES)),
                           load(offsetof(seccomp_data, nr))});
#endif
  code.insert(code.end(), {equals(SYS_clone, 0, 3), load(argument(0)), has_bit(CLONE_THREAD, 1, 0), give(kErrno(EPERM)),
                           give(SECCOMP_RET_ALLOW)});
  return code;
}

void set_limit(__rlimit_resource which, rlim_t most) {
  const rlimit limit{most, most};
  setrlimit(which, &limit);
}

/// Sets the limits of the new process, before it becomes the program.
void confine(const Limits& limits, std::vector<sock_filter>& code) {
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds) + 1);
  if (!limits.confined) return;
  set_limit(RLIMIT_FSIZE, 0);
  set_limit(RLIMIT_NOFILE, 32);
  unshare(CLONE_NEWUSER | CLONE_NEWNET);  // where it is allowed; the filter refuses sockets anyway
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  if (kArchitecture != 0) prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

// ---- running ---------------------------------------------------------------------------------------------------

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) == 0) read = ends[0], write = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() { close_read(), close_write(); }
  void close_read() { close_end(read); }
  void close_write() { close_end(write); }

 private:
  static void close_end(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
};

/// How many bytes of memory a process has in use.
std::int64_t memory_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::int64_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// Reads what is there. Returns false at the end.
bool read_some(int from, std::string& to) {
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(from, buffer.data(), buffer.size());
  if (count > 0) to.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

/// Gives the program its input and takes its output until it closes it, or a limit is reached.
class Conversation {
 public:
  Conversation(const Limits& limits, pid_t process, Pipe& in, Pipe& out, Pipe& err, std::string_view input)
      : limits_(limits), process_(process), in_(in), out_(out), err_(err), input_(input) {}

  Ended run() {
    fcntl(in_.write, F_SETFL, O_NONBLOCK);
    if (input_.empty()) in_.close_write();
    while (ended_.how == Ended::How::kDone && (out_.read >= 0 || err_.read >= 0)) step();
    if (ended_.how != Ended::How::kDone) ::kill(-process_, SIGKILL);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    if (ended_.how == Ended::How::kDone && WIFSIGNALED(status)) {
      const bool slow = WTERMSIG(status) == SIGXCPU;
      ended_.how = slow ? Ended::How::kTime : Ended::How::kSignal;
    }
    ended_.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return std::move(ended_);
  }

 private:
  void step() {
    constexpr int kLook = 20;  // milliseconds between two looks at the limits
    std::array<pollfd, 3> watched{{{out_.read, POLLIN, 0}, {err_.read, POLLIN, 0}, {in_.write, POLLOUT, 0}}};
    ::poll(watched.data(), watched.size(), kLook);
    if (watched[0].revents != 0 && !read_some(out_.read, ended_.out)) out_.close_read();
    if (watched[1].revents != 0 && !read_some(err_.read, ended_.err)) err_.close_read();
    if (watched[2].revents != 0) write_some();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
    if (passed.count() > limits_.seconds) ended_.how = Ended::How::kTime;
    if (memory_of(process_) > limits_.bytes) ended_.how = Ended::How::kMemory;
    if (static_cast<std::int64_t>(ended_.out.size() + ended_.err.size()) > limits_.bytes / 16)
      ended_.how = Ended::How::kOutput;
  }

  void write_some() {
    const ssize_t count = ::write(in_.write, input_.data(), input_.size());
    if (count > 0) input_.remove_prefix(static_cast<std::size_t>(count));
    if (input_.empty() || (count < 0 && errno != EAGAIN && errno != EINTR)) in_.close_write();
  }

  const Limits& limits_;
  pid_t process_;
  Pipe &in_, &out_, &err_;
  std::string_view input_;
  Ended ended_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace

Ended run_within(const Limits& limits, const std::vector<std::string>& arguments, std::string_view input,
                 const std::vector<std::string>& environment) {
  Pipe in, out, err;
  std::vector<std::string> words = arguments, own = environment;
  for (char** one = environ; *one != nullptr; ++one) own.emplace_back(*one);
  std::vector<char*> argv = pointers(words), envp = pointers(own);
  std::vector<sock_filter> code = filter();
  std::signal(SIGPIPE, SIG_IGN);
  const pid_t process = ::fork();
  if (process < 0) return {.how = Ended::How::kNotStarted};
  if (process == 0) {
    constexpr int kNoSuchProgram = 127;
    ::setpgid(0, 0);
    ::dup2(in.read, STDIN_FILENO), ::dup2(out.write, STDOUT_FILENO), ::dup2(err.write, STDERR_FILENO);
    std::signal(SIGPIPE, SIG_DFL);
    confine(limits, code);
    ::execvpe(argv[0], argv.data(), envp.data());
    ::_exit(kNoSuchProgram);
  }
  ::setpgid(process, process);
  in.close_read(), out.close_write(), err.close_write();
  return Conversation(limits, process, in, out, err, input).run();
}

}  // namespace snug::desktop
