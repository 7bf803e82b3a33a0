// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <string>

/// The shipped content in a temporary folder, to be damaged one file at a time.
class ContentCopy {
public:
    ContentCopy() {
        const QString source = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content");
        QDirIterator it(source, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile from(it.next());
            const QString relative = from.fileName().mid(source.size() + 1);
            QDir().mkpath(QFileInfo(path(relative)).path());
            if (from.open(QIODevice::ReadOnly))
                write(relative, from.readAll());
        }
    }

    std::string directory() const { return m_folder.path().toStdString(); }
    QString path(const QString& relative) const { return m_folder.path() + u'/' + relative; }

    QByteArray read(const QString& relative) const {
        QFile file(path(relative));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    void write(const QString& relative, const QByteArray& bytes) const {
        QFile::remove(path(relative)); // truncating a file makes some file systems wait for the disk
        QFile file(path(relative));
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes);
    }

private:
    QTemporaryDir m_folder;
};
