// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace chiron::test {

/// One text of a catalogue, as lupdate writes it.
struct TsMessage {
    QString context;
    QString source;
    QString comment;          ///< what tells apart two equal texts of a context; mostly empty
    QStringList translations; ///< one, or the plural forms in the order of the language
    bool counts = false;      ///< has plural forms
    bool finished = false;    ///< not marked unfinished, vanished or obsolete

    /// What makes a text the same text in two catalogues.
    QString key() const;
};

/// Reads a .ts file; nothing when it cannot be read or is not one.
std::optional<std::vector<TsMessage>> readTs(const QString& path);

} // namespace chiron::test
