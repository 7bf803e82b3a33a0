// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/same_disk.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>
#include <filesystem>

namespace chiron::session {

namespace {

/// The path or its nearest parent that exists.
QString present(const std::string& place) {
    QString path = QFileInfo(QString::fromStdString(place)).absoluteFilePath();
    while (!QFileInfo::exists(path) && path != QLatin1String("/"))
        path = QFileInfo(path).path();
    return path;
}

/// "/dev/nvme0n1p2" -> "nvme0n1"; a device that is not a partition of a disk is returned as it is.
std::string diskOf(const QByteArray& device) {
    std::error_code error;
    const auto name =
        std::filesystem::path(std::filesystem::canonical(device.toStdString(), error)).filename();
    const auto block = std::filesystem::canonical(std::filesystem::path("/sys/class/block") / name, error);
    if (error || !std::filesystem::exists(block / "partition", error))
        return device.toStdString();
    return block.parent_path().filename().string();
}

} // namespace

bool onOneDisk(const std::string& a, const std::string& b) {
    const QStorageInfo first(present(a)), second(present(b));
    if (first.rootPath() == second.rootPath())
        return true;
    return first.device().startsWith("/dev/") && second.device().startsWith("/dev/") &&
           diskOf(first.device()) == diskOf(second.device());
}

} // namespace chiron::session
