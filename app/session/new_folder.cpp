// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/new_folder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace chiron::session {

namespace {

core::Error storageError(const QString& path, const QString& why) {
    return {core::ErrorCode::storage, (path + ": cannot be written: " + why).toStdString()};
}

tl::unexpected<core::Error> alreadyThere(const QString& folder) {
    return core::fail(core::ErrorCode::badInput,
                      folder.toStdString() + ": exists already; expected a folder that is not there yet");
}

QFileInfo cleaned(const std::filesystem::path& folder) {
    return QFileInfo(QDir::cleanPath(QFileInfo(QString::fromStdString(folder.string())).absoluteFilePath()));
}

} // namespace

core::Result<void> NewFolder::isFree(const std::filesystem::path& folder) {
    const QFileInfo info = cleaned(folder);
    if (info.exists() || info.isSymLink())
        return alreadyThere(info.filePath());
    return {};
}

core::Result<NewFolder> NewFolder::begin(const std::filesystem::path& folder) {
    NewFolder made;
    const QFileInfo info = cleaned(folder);
    made.m_folder = info.filePath();
    CHIRON_TRY(isFree(folder));
    if (!QDir().mkpath(info.path()))
        return tl::unexpected(storageError(info.path(), QStringLiteral("the folder cannot be made")));
    made.m_partial = std::make_unique<QTemporaryDir>(info.path() + u'/' + info.fileName() +
                                                     QStringLiteral(".partial-XXXXXX"));
    if (!made.m_partial->isValid())
        return tl::unexpected(storageError(made.m_folder, made.m_partial->errorString()));
    return made;
}

core::Result<QString> NewFolder::place(const QString& name) {
    const QString path = m_partial->filePath(name);
    if (!QDir().mkpath(QFileInfo(path).path()))
        return tl::unexpected(storageError(path, QStringLiteral("its folder cannot be made")));
    return path;
}

core::Result<void> NewFolder::write(const QString& name, const QByteArray& bytes) {
    const auto path = place(name);
    CHIRON_TRY(path);
    QFile file(*path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        return tl::unexpected(storageError(*path, file.errorString()));
    return {};
}

core::Result<void> NewFolder::commit() {
    if (QFileInfo::exists(m_folder))
        return alreadyThere(m_folder);
    std::error_code code;
    std::filesystem::rename(m_partial->path().toStdString(), m_folder.toStdString(), code);
    if (code)
        return tl::unexpected(storageError(m_folder, QString::fromStdString(code.message())));
    m_partial->setAutoRemove(false);
    return {};
}

} // namespace chiron::session
