// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QString>
#include <QTemporaryDir>
#include <filesystem>
#include <memory>

namespace chiron::session {

/// A folder that appears either complete or not at all: it is written beside its final place under another
/// name and then renamed. Without commit() it is deleted.
class NewFolder {
public:
    /// Checks that the path is unused.
    /// Errors: badInput.
    static core::Result<void> isFree(const std::filesystem::path& folder);
    /// Begins a new folder.
    /// Errors: badInput if `folder` exists; storage if its parent is not writable.
    static core::Result<NewFolder> begin(const std::filesystem::path& folder);

    /// Returns the absolute path of a new file and creates its parent folders. `name` separates folders by
    /// "/".
    core::Result<QString> place(const QString& name);
    core::Result<void> write(const QString& name, const QByteArray& bytes);
    /// Renames the folder to its final name.
    /// Errors: badInput if the path has been used in the meantime; storage.
    core::Result<void> commit();

private:
    QString m_folder;
    std::unique_ptr<QTemporaryDir> m_partial;
};

} // namespace chiron::session
