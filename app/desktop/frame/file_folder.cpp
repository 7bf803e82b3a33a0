// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/file_folder.h"

#include "desktop/frame/settings.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace chiron::desktop {

namespace {

QString documents() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

QString firstThatIsThere(const QStringList& folders) {
    for (const QString& folder : folders)
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    return documents();
}

} // namespace

void beginInLastFolder(Settings& settings, QFileDialog& dialog, const QString& purpose,
                       const QString& usual) {
    dialog.setDirectory(firstThatIsThere({settings.lastFolder(purpose), usual}));
    QObject::connect(&dialog, &QFileDialog::fileSelected, &dialog,
                     [&settings, &dialog, purpose](const QString& chosen) {
                         settings.setLastFolder(purpose, dialog.fileMode() == QFileDialog::Directory
                                                             ? chosen
                                                             : QFileInfo(chosen).absolutePath());
                     });
}

} // namespace chiron::desktop
