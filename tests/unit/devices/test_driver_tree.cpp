// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

namespace {

QSet<QString> driverFolders() {
    const QDir drivers(QStringLiteral(CHIRON_SOURCE_DIR "/modules/devices/drivers"));
    const QStringList names = drivers.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    return QSet<QString>(names.begin(), names.end());
}

/// Whether a source includes a file of a driver, or asks whether a driver's id is this one.
bool namesADriver(const QString& source, const QSet<QString>& drivers) {
    for (const QString& driver : drivers) {
        const QString asked =
            QStringLiteral(
                "[dD]river(\\.id)?\\s*[=!]=\\s*(QLatin1String\\(|QStringLiteral\\()?\"%1\"|id == \"%1\"")
                .arg(driver);
        if (source.contains(QStringLiteral("#include \"devices/drivers/%1/").arg(driver)) ||
            source.contains(QRegularExpression(asked)))
            return true;
    }
    return false;
}

} // namespace

/// Adding a driver touches its own folder and one line: no shared source may name one.
class TestDriverTree : public QObject {
    Q_OBJECT

private slots:
    void noSharedSourceNamesADriver() {
        const QSet<QString> drivers = driverFolders();
        QVERIFY(drivers.contains(QStringLiteral("keyboard_mouse")));
        const QDir root(QStringLiteral(CHIRON_SOURCE_DIR));
        QStringList found;
        for (const char* floor : {"app", "curriculum", "database", "modules"}) {
            QDirIterator files(root.filePath(QLatin1String(floor)), {"*.h", "*.cpp"}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                const QString path = root.relativeFilePath(file.fileName());
                if (path.startsWith(QStringLiteral("modules/devices/drivers/")) ||
                    path == QStringLiteral("modules/devices/driver_catalogue.cpp"))
                    continue;
                QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(path));
                if (namesADriver(QString::fromUtf8(file.readAll()), drivers))
                    found << path;
            }
        }
        found.sort();
        QCOMPARE(found.join('\n'), QString());
    }
};

QTEST_GUILESS_MAIN(TestDriverTree)
#include "test_driver_tree.moc"
