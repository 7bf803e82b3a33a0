// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/translations/content_sentences.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace chiron::test {

namespace {

class Reader {
public:
    Reader(QString folder, QString language, QStringList& faults)
        : m_folder(std::move(folder)), m_language(std::move(language)), m_faults(faults) {}

    /// The parts of one folder: the file of each part in English, and its texts.
    void read(const QString& folder, const QJsonObject& texts, const QString& files) {
        for (const QString& id : texts.keys())
            pair(object(folder + files + id), texts[id], folder + QLatin1Char('/') + id);
    }
    void readExercise(const QString& folder) {
        const QJsonObject texts = translated(folder);
        pair(object(folder + QStringLiteral("/exercise")), texts["exercise"],
             folder + QStringLiteral("/exercise"));
        for (const char* parts : {"levels", "presets"})
            read(folder + QLatin1Char('/') + QLatin1String(parts), texts[QLatin1String(parts)].toObject(),
                 QStringLiteral("/"));
    }
    QJsonObject translated(const QString& folder) {
        return object(folder + QStringLiteral("/texts/") + m_language);
    }
    std::vector<Sentence> take() { return std::move(m_found); }

private:
    QJsonObject object(const QString& path) {
        QFile file(m_folder + QLatin1Char('/') + path + QStringLiteral(".json"));
        const QJsonDocument json =
            file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()) : QJsonDocument();
        if (!json.isObject())
            m_faults << file.fileName() + QStringLiteral(": no JSON object");
        return json.object();
    }

    void pair(const QJsonValue& english, const QJsonValue& translation, const QString& place) {
        if (english.isString() && translation.isString()) {
            m_found.push_back(
                {QStringLiteral("content/") + place, english.toString(), translation.toString()});
        } else if (english.isArray() && translation.isArray()) {
            const QJsonArray all = english.toArray(), other = translation.toArray();
            for (qsizetype i = 0; i < std::min(all.size(), other.size()); ++i)
                pair(all[i], other[i], place + QLatin1Char('/') + QString::number(i));
        } else if (translation.isObject()) {
            const QJsonObject texts = translation.toObject();
            for (const QString& key : texts.keys())
                pair(memberOf(english, key), texts[key], place + QLatin1Char('/') + key);
        } else {
            m_faults << place + QStringLiteral(": nothing in English");
        }
    }

    /// A member of an object, or the element of a list that has this name.
    static QJsonValue memberOf(const QJsonValue& english, const QString& key) {
        for (const QJsonValue& element : english.toArray())
            for (const char* name : {"id", "metric", "mark"})
                if (element.toObject()[QLatin1String(name)].toString() == key)
                    return element;
        const QJsonObject object = english.toObject();
        return object.contains(key) ? object[key]
                                    : object["questionnaire"].toObject()[key]; // of an instrument
    }

    QString m_folder;
    QString m_language;
    QStringList& m_faults;
    std::vector<Sentence> m_found;
};

} // namespace

std::vector<Sentence> contentSentences(const QString& folder, const QString& language, QStringList& faults) {
    Reader reader(folder, language, faults);
    for (const QString& id :
         QDir(folder + QStringLiteral("/exercises")).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        reader.readExercise(QStringLiteral("exercises/") + id);
    for (const char* part : {"objects", "meshes", "tissues", "studies", "instruments"})
        reader.read(QLatin1String(part), reader.translated(QLatin1String(part)), QStringLiteral("/"));
    return reader.take();
}

} // namespace chiron::test
