// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <filesystem>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace chiron::bench {

/// What a loop must live with: processes that use all the time they get, and one that writes 64 KiB and
/// fsyncs, again and again, into a file of `folder`. They end with this object, or with this process.
class Disturbers {
public:
    Disturbers(int busy, const std::filesystem::path& folder) {
        for (int i = 0; i < busy; ++i)
            start([] {
                for (;;)
                    __asm__ volatile(""); // nothing, as fast as it can, and the compiler must not know better
            });
        m_file = folder / "chiron-bench-fsync";
        start([file = m_file] {
            static char block[65536];
            const int descriptor = open(file.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
            for (long n = 0;; ++n)
                if (pwrite(descriptor, block, sizeof block, (n % 256) * static_cast<long>(sizeof block)) <
                        0 ||
                    fsync(descriptor) != 0)
                    _exit(1);
        });
    }
    Disturbers(const Disturbers&) = delete;
    Disturbers& operator=(const Disturbers&) = delete;
    ~Disturbers() {
        for (const pid_t child : m_children) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
        std::error_code ignored; // a file that was never made
        std::filesystem::remove(m_file, ignored);
    }

private:
    template <class Work> void start(Work&& work) {
        const pid_t child = fork();
        if (child == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            work();
        }
        if (child > 0)
            m_children.push_back(child);
    }

    std::vector<pid_t> m_children;
    std::filesystem::path m_file;
};

} // namespace chiron::bench
