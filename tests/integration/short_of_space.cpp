// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_of_space.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <string>
#include <sys/mount.h>
#include <unistd.h>

FileSizeLimit::FileSizeLimit(std::uint64_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &m_before);
    rlimit limit = m_before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
}

FileSizeLimit::~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &m_before);
}

TinyFileSystem::TinyFileSystem(int kilobytes) {
    const std::string size = "size=" + std::to_string(kilobytes) + "k";
    m_mounted = mount("tmpfs", path().toLocal8Bit().constData(), "tmpfs", 0, size.c_str()) == 0;
}

TinyFileSystem::~TinyFileSystem() {
    if (m_mounted)
        umount2(path().toLocal8Bit().constData(), MNT_DETACH);
}

void TinyFileSystem::fill() const {
    const int filler =
        open((path() + "/filler").toLocal8Bit().constData(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    const std::array<char, 4096> page{};
    while (filler >= 0 && write(filler, page.data(), page.size()) == static_cast<ssize_t>(page.size())) {
    }
    close(filler);
}

void TinyFileSystem::empty() const {
    unlink((path() + "/filler").toLocal8Bit().constData());
}
