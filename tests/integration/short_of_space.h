// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>
#include <cstdint>
#include <memory>
#include <sys/resource.h>

/// While it lives, no file of this program may grow beyond `bytes`: writes fail with EFBIG instead of a
/// signal.
class FileSizeLimit {
public:
    explicit FileSizeLimit(std::uint64_t bytes);
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit();

private:
    rlimit m_before{};
};

/// A file system of its own, a few MB in memory; only where mounting is permitted.
class TinyFileSystem {
public:
    explicit TinyFileSystem(int kilobytes);
    TinyFileSystem(const TinyFileSystem&) = delete;
    TinyFileSystem& operator=(const TinyFileSystem&) = delete;
    ~TinyFileSystem();

    bool isMounted() const noexcept { return m_mounted; }
    QString path() const { return m_folder.path(); }
    /// Takes all room that is left; afterwards every write of a new page fails with ENOSPC.
    void fill() const;
    void empty() const; ///< gives that room back

private:
    QTemporaryDir m_folder;
    bool m_mounted = false;
};
