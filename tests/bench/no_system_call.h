// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <linux/seccomp.h>
#include <optional>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace chiron::bench {

/// Runs `work` in a child process that the kernel kills at its first system call (strict seccomp; exit alone
/// is allowed). True if it came to its end; nothing where the kernel has no seccomp.
template <class Work> std::optional<bool> makesNoSystemCall(Work&& work) {
    constexpr int kNoSeccomp = 3;
    const pid_t child = fork();
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0)
            _exit(kNoSeccomp);
        work();
        syscall(SYS_exit, 0);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child ||
        (WIFEXITED(status) && WEXITSTATUS(status) == kNoSeccomp))
        return std::nullopt;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace chiron::bench
