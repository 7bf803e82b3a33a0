// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/language_words.h"

#include "catalogue/json_file.h"
#include "catalogue/schema.h"
#include "core/languages.h"

#include <QFile>
#include <QJsonArray>
#include <algorithm>

// Resources of a static library are not registered automatically; the macro must stand outside any namespace.
static void registerLanguageWords() {
    Q_INIT_RESOURCE(language_words);
}

namespace chiron::catalogue {

namespace {

QStringList listIn(const QJsonValue& value) {
    QStringList words;
    for (const QJsonValue word : value.toArray())
        words << word.toString();
    return words;
}

std::map<QString, QStringList> listsIn(const QJsonValue& value) {
    const QJsonObject object = value.toObject();
    std::map<QString, QStringList> lists;
    for (auto it = object.begin(); it != object.end(); ++it)
        lists.emplace(it.key(), listIn(it.value()));
    return lists;
}

LanguageWords::Claims claimsIn(const QJsonObject& json) {
    LanguageWords::Claims claims;
    for (const auto& [number, words] : listsIn(json["numbers"]))
        claims.numbers.emplace(number.toInt(), words);
    claims.objects = listIn(json["objects"]);
    claims.trials = listIn(json["trials"]);
    claims.seconds = listIn(json["seconds"]);
    claims.criterionThreeOfFour = listIn(json["criterion_three_of_four"]);
    claims.objectsNotSeen = listIn(json["objects_not_seen"]);
    claims.objectsSeen = listIn(json["objects_seen"]);
    claims.timeNotLimited = listIn(json["time_not_limited"]);
    return claims;
}

core::Result<LanguageWords> builtInWords(const std::string& language) {
    QFile file(QStringLiteral(":/words/%1.json").arg(QString::fromStdString(language)));
    if (!file.open(QIODevice::ReadOnly))
        return core::fail(core::ErrorCode::notFound, "translations/words/" + language +
                                                         ".json: not in the program: expected a file for "
                                                         "each language of core/languages.h");
    return readLanguageWords(language, file.readAll());
}

} // namespace

core::Result<LanguageWords> readLanguageWords(const std::string& language, const QByteArray& json) {
    registerLanguageWords();
    const auto schema = readSchema(QStringLiteral(":/words/schema"), QStringLiteral("words"));
    CHIRON_TRY(schema);
    const auto file = JsonFile::parse(
        json, QStringLiteral("translations/words/%1.json").arg(QString::fromStdString(language)));
    CHIRON_TRY(file);
    Problems problems;
    const QJsonObject words = validated(file->root(), *schema, QStringLiteral("$"), problems).toObject();
    if (!problems.empty())
        return tl::unexpected(file->error(problems));
    const QJsonObject roster = words["roster"].toObject();
    return LanguageWords{language, words["pilot_prefix"].toString().toStdString(),
                         LanguageWords::Roster{listsIn(roster["headings"]), listsIn(roster["roles"])},
                         claimsIn(words["claims"].toObject())};
}

const std::vector<LanguageWords>& languageWords() {
    static const std::vector<LanguageWords> all = [] {
        registerLanguageWords();
        std::vector<LanguageWords> read;
        for (const std::string& language : core::languageIds()) {
            auto words = builtInWords(language);
            if (!words)
                qFatal("%s", words.error().message.c_str());
            read.push_back(*std::move(words));
        }
        return read;
    }();
    return all;
}

const LanguageWords& wordsOfLanguage(std::string_view language) {
    const std::vector<LanguageWords>& all = languageWords();
    const auto found = std::find_if(
        all.begin(), all.end(), [language](const LanguageWords& each) { return each.language == language; });
    return found == all.end() ? all.front() : *found;
}

} // namespace chiron::catalogue
