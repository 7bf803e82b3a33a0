// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/started_process.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace chiron::bench {

namespace {

constexpr int kLongest_ms = 10'000;

long long now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<long long>(now.tv_sec) * 1'000'000'000LL + now.tv_nsec;
}

/// Adds the times of whole lines; true when `last` was among them.
bool readLines(std::string& text, long long begin_ns, const std::string& last,
               std::map<std::string, StartStep>& times) {
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
        char what[64] = {};
        long long at_ns = 0;
        long long cpu_ns = 0;
        if (std::sscanf(text.c_str(), "chiron-start %63s %lld %lld", what, &at_ns, &cpu_ns) == 3)
            times.emplace(what, StartStep{static_cast<double>(at_ns - begin_ns) * 1e-6,
                                          static_cast<double>(cpu_ns) * 1e-6});
        text.erase(0, end + 1);
    }
    return times.contains(last);
}

} // namespace

std::map<std::string, StartStep> startUntil(const std::vector<std::string>& command,
                                            const std::string& last) {
    setenv("CHIRON_START_TRACE", "1", 1);
    int ends[2] = {};
    if (pipe(ends) != 0)
        return {};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    const long long begin_ns = now_ns();
    const int failed =
        posix_spawn(&child, command.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    std::map<std::string, StartStep> times;
    std::string text;
    bool there = false;
    char buffer[4096];
    pollfd waited{ends[0], POLLIN, 0};
    while (failed == 0 && !there && poll(&waited, 1, kLongest_ms) > 0) {
        const ssize_t count = read(ends[0], buffer, sizeof buffer);
        if (count <= 0)
            break;
        text.append(buffer, static_cast<std::size_t>(count));
        there = readLines(text, begin_ns, last, times);
    }
    close(ends[0]);
    if (failed == 0) {
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }
    return there ? times : std::map<std::string, StartStep>{};
}

} // namespace chiron::bench
