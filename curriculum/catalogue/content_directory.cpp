// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStringList>

namespace chiron::catalogue {

namespace {

/// Looks for `share/chiron/content` under the program's own prefix first, then in the system's data folders.
QStringList installedPlaces() {
    QStringList places;
    if (QCoreApplication::instance() != nullptr)
        places << QCoreApplication::applicationDirPath() + "/../share/chiron/content";
    for (const QString& folder : QStandardPaths::standardLocations(QStandardPaths::GenericDataLocation))
        places << folder + "/chiron/content";
    return places;
}

bool isContent(const QString& folder) {
    return QFileInfo(folder + "/exercises").isDir() && QFileInfo(folder + "/schema").isDir();
}

} // namespace

core::Result<std::string> findContentDirectory(const std::string& explicitDirectory) {
    QStringList places;
    if (!explicitDirectory.empty()) {
        places << QString::fromStdString(explicitDirectory); // explicitly requested: use no other
    } else if (qEnvironmentVariableIsSet("CHIRON_CONTENT")) {
        places << qEnvironmentVariable("CHIRON_CONTENT");
    } else {
        places << installedPlaces() << QStringLiteral(CHIRON_CONTENT_SOURCE_DIRECTORY);
    }
    for (const QString& place : places)
        if (isContent(place))
            return place.toStdString();
    return core::fail(core::ErrorCode::notFound, ("content: not found in " + places.join(", ") +
                                                  ": expected a folder with exercises/ and schema/ in it")
                                                     .toStdString());
}

} // namespace chiron::catalogue
