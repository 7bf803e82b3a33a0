// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QString>
#include <QTemporaryDir>
#include <filesystem>
#include <memory>

namespace chiron::session {

/// A folder that appears whole or not at all: written beside its place under another name, then renamed. Gone where it is not committed.
class NewFolder {
public:
    /// Whether nothing is there. Failure: badInput.
    static core::Result<void> isFree(const std::filesystem::path& folder);
    /// Failure: badInput where `folder` exists; storage where nothing can be written beside it.
    static core::Result<NewFolder> begin(const std::filesystem::path& folder);

    /// Absolute path of a file to be, its folders made. `name`: with / between folders.
    core::Result<QString> place(const QString& name);
    core::Result<void> write(const QString& name, const QByteArray& bytes);
    /// Failure: badInput where something has come to be there meanwhile; storage.
    core::Result<void> commit();

private:
    QString m_folder;
    std::unique_ptr<QTemporaryDir> m_partial;
};

} // namespace chiron::session
