// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/content_texts.h"

#include "catalogue/canonical_json.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <algorithm>

namespace chiron::catalogue {

namespace {

const QString kSource = QStringLiteral("en");

QString joined(const std::vector<QString>& words) {
    return QStringList(words.begin(), words.end()).join(QStringLiteral(", "));
}

QString languagesOf(const std::vector<std::string>& languages, std::size_t from) {
    std::vector<QString> words;
    for (std::size_t i = from; i < languages.size(); ++i)
        words.push_back(QString::fromStdString(languages[i]));
    return joined(words);
}

bool isText(const Schema& schema) {
    return schema.translated;
}

/// Returns whether a value of this schema contains a text to be translated.
bool hasTexts(const Schema& schema) {
    return isText(schema) || (schema.items && hasTexts(*schema.items)) ||
           std::any_of(schema.properties.begin(), schema.properties.end(),
                       [](const auto& property) { return hasTexts(*property.second); });
}

/// Returns the member that identifies an element of a list independently of its position.
QString nameKey(const Schema& element) {
    for (const char* key : {"id", "metric", "mark"})
        if (element.properties.contains(QLatin1String(key)))
            return QLatin1String(key);
    return {};
}

QString kindOf(const QJsonValue& value) {
    if (value.isObject())
        return QStringLiteral("an object");
    if (value.isArray())
        return QStringLiteral("an array of %1").arg(value.toArray().size());
    return value.isString() ? quoted(value.toString()) : QStringLiteral("another type");
}

/// Returns a text as an object by language, whichever way it was written.
QJsonValue byLanguage(const QJsonValue& value) {
    return value.isString() ? QJsonValue(QJsonObject{{kSource, value}}) : value;
}

} // namespace

core::Result<ContentTexts> ContentTexts::read(const QString& folder,
                                              const std::vector<std::string>& languages) {
    ContentTexts out;
    out.m_languages = languages;
    const auto refuse = [](const QString& path, const QString& found, const QString& expected) {
        return core::fail(
            core::ErrorCode::badInput,
            QStringLiteral("%1:1:1: $: %2: expected %3").arg(path, found, expected).toStdString());
    };
    for (const QFileInfo& info :
         QDir(folder + QStringLiteral("/texts")).entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        const QString path = QDir::cleanPath(info.filePath());
        const QString language = info.completeBaseName();
        if (language == kSource)
            return refuse(path, QStringLiteral("the texts in English"),
                          QStringLiteral("them in the content files themselves"));
        if (std::find(languages.begin(), languages.end(), language.toStdString()) == languages.end())
            return refuse(
                path, QStringLiteral("the unknown language %1").arg(quoted(language)),
                QStringLiteral("the file of a language of the program: %1").arg(languagesOf(languages, 1)));
        auto json = JsonFile::read(path);
        CHIRON_TRY(json);
        out.m_files.push_back({language.toStdString(), std::move(*json), {}});
    }
    return out;
}

core::Result<std::optional<Schema>> ContentTexts::schemaOfTexts(const QString& contentDirectory,
                                                                const QString& name) const {
    if (m_files.empty())
        return std::optional<Schema>();
    return readSchema(contentDirectory + QStringLiteral("/schema"), name).map([](Schema schema) {
        return std::optional(std::move(schema));
    });
}

QJsonValue ContentTexts::elementsLaidOver(const QJsonArray& array, const Schema& schema,
                                          const QJsonValue& given, const QString& path, File& file) const {
    QJsonArray out = array;
    if (isText(schema)) {
        const QJsonArray texts = given.toArray();
        if (!given.isArray() || texts.size() != array.size()) {
            file.problems.push_back(
                {path, kindOf(given),
                 QStringLiteral("an array of %1 texts, as the content has").arg(array.size())});
            return array;
        }
        for (qsizetype i = 0; i < array.size(); ++i)
            out[i] = laidOver(array[i], schema, texts[i], elementPath(path, i), file);
        return out;
    }
    if (!given.isObject()) {
        file.problems.push_back(
            {path, kindOf(given), QStringLiteral("an object with the texts of each element")});
        return array;
    }
    const QString key = nameKey(schema);
    std::vector<QString> names;
    for (const QJsonValue element : array)
        names.push_back(element.toObject()[key].toString());
    const QJsonObject texts = given.toObject();
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        const auto found = std::find(names.begin(), names.end(), it.key());
        const QString at = memberPath(path, it.key());
        if (found == names.end())
            file.problems.push_back(
                {at, QStringLiteral("the content has no such %1").arg(key),
                 QStringLiteral("one of ") + joined(names) + didYouMean(it.key(), names)});
        else
            out[found - names.begin()] = laidOver(array[found - names.begin()], schema, it.value(), at, file);
    }
    return out;
}

QJsonValue ContentTexts::laidOver(const QJsonValue& value, const Schema& schema, const QJsonValue& given,
                                  const QString& path, File& file) const {
    if (isText(schema)) {
        if (!given.isString()) {
            file.problems.push_back({path, kindOf(given), QStringLiteral("a text")});
            return value;
        }
        validated(given, schema, path, file.problems);
        if (!value.isString() && !value.isObject())
            return value; // not a text at all: reported for the content file
        QJsonObject texts = byLanguage(value).toObject();
        const QString language = QString::fromStdString(file.language);
        if (texts.contains(language))
            file.problems.push_back(
                {path, QStringLiteral("given twice"),
                 QStringLiteral("it here or in the content file, which has this text in %1, too")
                     .arg(quoted(language))});
        texts[language] = given.toString();
        return texts;
    }
    if (schema.type == Schema::Type::array && schema.items)
        return elementsLaidOver(value.toArray(), *schema.items, given, path, file);
    if (!given.isObject()) {
        file.problems.push_back({path, kindOf(given), QStringLiteral("an object with texts")});
        return value;
    }
    QJsonObject out = value.toObject();
    std::vector<QString> known;
    for (const auto& [key, property] : schema.properties)
        if (out.contains(key) && hasTexts(*property))
            known.push_back(key);
    const QJsonObject texts = given.toObject();
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        const QString at = memberPath(path, it.key());
        if (std::find(known.begin(), known.end(), it.key()) == known.end())
            file.problems.push_back(
                {at, QStringLiteral("the content has no such text"),
                 QStringLiteral("one of ") + joined(known) + didYouMean(it.key(), known)});
        else
            out[it.key()] = laidOver(out[it.key()], *schema.properties.at(it.key()), it.value(), at, file);
    }
    return out;
}

void ContentTexts::note(const QJsonValue& value, const Schema& schema, const At& at, const QString& place,
                        Problems& problems) {
    if (isText(schema)) {
        const QJsonObject texts = byLanguage(value).toObject();
        for (const QString& language : texts.keys())
            if (std::find(m_languages.begin(), m_languages.end(), language.toStdString()) ==
                m_languages.end())
                problems.push_back({memberPath(at.path, language), QStringLiteral("an unknown language"),
                                    QStringLiteral("one of ") + languagesOf(m_languages, 0)});
        for (const std::string& language : m_languages) {
            const QString key = QString::fromStdString(language);
            if (texts.contains(key))
                m_texts[language][place + at.path] = texts[key];
            else
                m_missing.push_back({language, at.file.toStdString(), at.path.toStdString()});
        }
        return;
    }
    const QJsonObject object = value.toObject();
    for (const auto& [key, property] : schema.properties)
        if (object.contains(key) && hasTexts(*property))
            note(object[key], *property, {at.file, memberPath(at.path, key)}, place, problems);
    if (!schema.items || !hasTexts(*schema.items))
        return;
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i)
        note(array[i], *schema.items, {at.file, elementPath(at.path, i)}, place, problems);
}

QJsonObject ContentTexts::laid(const QJsonObject& document, const Schema& schema, const QStringList& place,
                               const QString& file, const QString& path, Problems& problems) {
    const QString claimed = place.join(u'/');
    m_claimed.insert(claimed);
    QJsonValue out = document;
    for (File& texts : m_files) {
        QJsonValue given = texts.json.root();
        QString at = QStringLiteral("$");
        for (const QString& key : place) {
            given = given.toObject().value(key);
            at = memberPath(at, key);
        }
        if (!given.isUndefined())
            out = laidOver(out, schema, given, at, texts);
    }
    note(out, schema, {file, path}, claimed, problems);
    return out.toObject();
}

void ContentTexts::refuseUnclaimed(const QJsonObject& entries, const QString& above, const QString& path,
                                   Problems& problems) const {
    std::vector<QString> known;
    for (const QString& claimed : m_claimed)
        if (claimed.startsWith(above))
            if (const QString key = claimed.mid(above.size()).section(u'/', 0, 0);
                std::find(known.begin(), known.end(), key) == known.end())
                known.push_back(key);
    for (auto it = entries.begin(); it != entries.end(); ++it) {
        const QString place = above + it.key();
        const QString at = memberPath(path, it.key());
        if (m_claimed.contains(place))
            continue;
        if (std::find(known.begin(), known.end(), it.key()) == known.end())
            problems.push_back({at, QStringLiteral("the content has no such part"),
                                QStringLiteral("one of ") + joined(known) + didYouMean(it.key(), known)});
        else if (!it.value().isObject())
            problems.push_back({at, kindOf(it.value()), QStringLiteral("an object with texts")});
        else
            refuseUnclaimed(it.value().toObject(), place + u'/', at, problems);
    }
}

core::Result<void> ContentTexts::finish() {
    for (File& file : m_files) {
        refuseUnclaimed(file.json.root(), QString(), QStringLiteral("$"), file.problems);
        if (!file.problems.empty())
            return tl::unexpected(file.json.error(file.problems));
    }
    return {};
}

std::map<std::string, std::string> ContentTexts::digests() const {
    std::map<std::string, std::string> out;
    for (const auto& [language, texts] : m_texts)
        out[language] = sha256Hex(canonicalJson(texts));
    return out;
}

} // namespace chiron::catalogue
