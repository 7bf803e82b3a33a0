// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/audit/site_key.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

namespace chiron::database {
namespace {

constexpr char kPrefix[] = "chiron-site-key-1 ";

std::string keyFile(const std::string& folder) {
    return folder + "/site.key";
}

bool putDown(int descriptor, const std::string& text) {
    return ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
           ::fsync(descriptor) == 0;
}

/// Gives a completely written file its name without ever replacing another file; returns 0, or errno.
int nameIt(const std::string& from, const std::string& to) {
    if (::link(from.c_str(), to.c_str()) == 0)
        return 0;
    if (errno == EEXIST)
        return EEXIST;
    // Some file systems (FAT) have no links.
    return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0 ? 0 : errno;
}

/// Writes the key to a temporary file and then names it, so that a program killed in between leaves either a
/// complete key or none. If another program was faster, its key remains.
core::Result<void> writeNew(const std::string& file, const std::string& text) {
    std::string aside = file + ".XXXXXX";
    // Mode 0600 from the first moment: the key is never readable by others, not even briefly.
    const int descriptor = ::mkostemp(aside.data(), O_CLOEXEC);
    if (descriptor < 0)
        return core::fail(core::ErrorCode::storage, file + ": the site key cannot be created");
    const bool written = putDown(descriptor, text);
    ::close(descriptor);
    const int refused = written ? nameIt(aside, file) : EIO;
    ::unlink(aside.c_str());
    if (refused != 0 && refused != EEXIST)
        return core::fail(core::ErrorCode::storage, file + ": the site key cannot be written (disk full?)");
    return {};
}

} // namespace

SiteKey::~SiteKey() {
    sodium_memzero(m_key.data(), m_key.size());
}

core::Result<std::unique_ptr<SiteKey>> SiteKey::createOrLoad(const std::string& siteFolder) {
    if (QFileInfo::exists(QString::fromStdString(keyFile(siteFolder)))) {
        return load(siteFolder);
    }
    if (sodium_init() < 0) {
        return core::fail(core::ErrorCode::storage, "libsodium cannot be started");
    }
    const QString folder = QString::fromStdString(siteFolder);
    if (!QDir().mkpath(folder) ||
        !QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner)) {
        return core::fail(core::ErrorCode::storage, siteFolder + ": the site folder cannot be created");
    }
    std::array<std::uint8_t, 32> key{};
    randombytes_buf(key.data(), key.size());
    auto written = writeNew(keyFile(siteFolder), kPrefix + hex(key.data(), key.size()) + "\n");
    sodium_memzero(key.data(), key.size());
    CHIRON_TRY(written);
    return load(siteFolder);
}

core::Result<std::unique_ptr<SiteKey>> SiteKey::load(const std::string& siteFolder) {
    const std::string name = keyFile(siteFolder);
    QFile file(QString::fromStdString(name));
    if (!file.exists()) {
        return core::fail(
            core::ErrorCode::notFound,
            name + ": the site key is missing; put it back from where the site keeps its copy (restore "
                   "--site-key FILE does so)");
    }
    if (sodium_init() < 0 || !file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorCode::storage, name + ": the site key cannot be read");
    }
    struct stat status {};
    if (::fstat(file.handle(), &status) != 0 || (status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return core::fail(core::ErrorCode::storage,
                          name + ": others may read the site key; allow its owner only (0600)");
    }
    const QByteArray text = file.read(256).trimmed();
    const QByteArray digits = text.startsWith(kPrefix) ? text.mid(sizeof(kPrefix) - 1) : QByteArray();
    const QByteArray bytes = QByteArray::fromHex(digits);
    if (digits.size() != 64 || bytes.size() != 32) {
        return core::fail(core::ErrorCode::storage,
                          name + ": not a site key (expected \"chiron-site-key-1\" and 64 hex digits)");
    }
    std::unique_ptr<SiteKey> key(new SiteKey(siteFolder));
    std::copy(bytes.begin(), bytes.end(), key->m_key.begin());
    return key;
}

RowDigest SiteKey::mac(std::span<const std::uint8_t> bytes) const {
    RowDigest mac{};
    crypto_generichash(mac.data(), mac.size(), bytes.data(), bytes.size(), m_key.data(), m_key.size());
    return mac;
}

} // namespace chiron::database
