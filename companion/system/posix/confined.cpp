#include <companion/system/posix/confined.hpp>

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__)) && \
    __has_include(<linux/seccomp.h>)
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace companion {
namespace {

#ifdef __x86_64__
constexpr std::uint32_t this_processor = AUDIT_ARCH_X86_64;
#else
constexpr std::uint32_t this_processor = AUDIT_ARCH_AARCH64;
#endif

// The options of clone3 are in memory that this filter cannot read. If the call is said not to
// exist, the C library uses clone instead.
constexpr std::uint32_t clone3 = 435;

// The offsets of the two halves of a system call's first argument.
constexpr std::uint32_t low = offsetof(seccomp_data, args), high = low + 4;

constexpr sock_filter load(std::uint32_t from) {
    return {BPF_LD | BPF_W | BPF_ABS, 0, 0, from};
}
// Goes on with the next step if the comparison holds; if not, skips this many steps.
constexpr sock_filter compare(int how, std::uint32_t with, std::uint8_t skipped) {
    return {static_cast<std::uint16_t>(BPF_JMP | how | BPF_K), 0, skipped, with};
}
constexpr sock_filter end_with(std::uint32_t verdict) {
    return {BPF_RET | BPF_K, 0, 0, verdict};
}

}  // namespace

void confine_to(const char* program) {
    const auto address = reinterpret_cast<std::uint64_t>(program);
    sock_filter steps[]{
        load(offsetof(seccomp_data, arch)),
        compare(BPF_JEQ, this_processor, 1),
        {BPF_JMP | BPF_JA, 0, 0, 1},
        end_with(SECCOMP_RET_KILL_PROCESS),
        load(offsetof(seccomp_data, nr)),
#ifdef __x86_64__
        compare(BPF_JGE, 0x40000000, 1),  // the x32 variants of the system calls
        end_with(SECCOMP_RET_KILL_PROCESS),
        compare(BPF_JEQ, __NR_fork, 1),
        end_with(SECCOMP_RET_KILL_PROCESS),
        compare(BPF_JEQ, __NR_vfork, 1),
        end_with(SECCOMP_RET_KILL_PROCESS),
#endif
        compare(BPF_JEQ, __NR_execveat, 1),
        end_with(SECCOMP_RET_KILL_PROCESS),
        compare(BPF_JEQ, clone3, 1),
        end_with(SECCOMP_RET_ERRNO | ENOSYS),
        // A clone that shares the memory is allowed, except for a vfork: it is a thread, or a
        // helper of the leak sanitizer.
        compare(BPF_JEQ, __NR_clone, 6),
        load(low),
        compare(BPF_JSET, CLONE_VFORK, 1),
        end_with(SECCOMP_RET_KILL_PROCESS),
        compare(BPF_JSET, CLONE_VM, 1),
        end_with(SECCOMP_RET_ALLOW),
        end_with(SECCOMP_RET_KILL_PROCESS),
        compare(BPF_JEQ, __NR_execve, 5),
        load(low),
        compare(BPF_JEQ, static_cast<std::uint32_t>(address), 2),
        load(high),
        {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, static_cast<std::uint32_t>(address >> 32)},
        end_with(SECCOMP_RET_KILL_PROCESS),
        end_with(SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter{static_cast<unsigned short>(std::size(steps)), steps};
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

}  // namespace companion
#else
namespace companion {
void confine_to(const char*) {}
}  // namespace companion
#endif
