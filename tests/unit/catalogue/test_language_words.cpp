// SPDX-License-Identifier: GPL-3.0-or-later
// Every language has the words that the program stores or recognises; what a file lacks is said with its
// place.
#include "catalogue/language_words.h"
#include "core/languages.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;
using catalogue::readLanguageWords;

namespace {

QByteArray fileOf(const std::string& language) {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/translations/words/%1.json")
                   .arg(QString::fromStdString(language)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The English words with one entry replaced, or left out where `value` is undefined.
QByteArray englishWith(const QStringList& path, const QJsonValue& value) {
    const auto with = [&](const auto& self, QJsonObject object, qsizetype depth) -> QJsonObject {
        const QString& key = path[depth];
        if (depth + 1 < path.size())
            object[key] = self(self, object[key].toObject(), depth + 1);
        else if (value.isUndefined())
            object.remove(key);
        else
            object[key] = value;
        return object;
    };
    return QJsonDocument(with(with, QJsonDocument::fromJson(fileOf("en")).object(), 0)).toJson();
}

std::string refusal(const QByteArray& json) {
    const auto words = readLanguageWords("xx", json);
    return words ? std::string() : words.error().message;
}

} // namespace

class TestLanguageWords : public QObject {
    Q_OBJECT
private slots:
    void everyLanguageHasItsWords();
    void theProgramHasThem();
    void whatIsMissingIsNamed_data();
    void whatIsMissingIsNamed();
    void otherFaultsAreNamed();
};

void TestLanguageWords::everyLanguageHasItsWords() {
    for (const std::string& language : core::languageIds()) {
        const auto words = readLanguageWords(language, fileOf(language));
        QVERIFY2(words, words ? "" : words.error().message.c_str());
        QCOMPARE(words->language, language);
        QVERIFY2(words->pilotPrefix.ends_with(": "), language.c_str());
    }
}

void TestLanguageWords::theProgramHasThem() {
    const auto& all = catalogue::languageWords();
    const std::vector<std::string> languages = core::languageIds();
    QCOMPARE(all.size(), languages.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto read = readLanguageWords(languages[i], fileOf(languages[i]));
        QVERIFY(read);
        QCOMPARE(all[i].language, languages[i]);
        QCOMPARE(all[i].pilotPrefix, read->pilotPrefix);
        QVERIFY(all[i].roster.headings == read->roster.headings && all[i].roster.roles == read->roster.roles);
        QCOMPARE(&catalogue::wordsOfLanguage(languages[i]), &all[i]);
    }
    QCOMPARE(catalogue::wordsOfLanguage("xx").language, std::string("en"));
}

void TestLanguageWords::whatIsMissingIsNamed_data() {
    QTest::addColumn<QStringList>("path");
    for (const char* path :
         {"pilot_prefix", "roster", "claims", "roster.headings", "roster.roles", "roster.headings.login_name",
          "roster.roles.trainee", "claims.numbers", "claims.seconds", "claims.time_not_limited"})
        QTest::newRow(path) << QString::fromLatin1(path).split(QLatin1Char('.'));
}

void TestLanguageWords::whatIsMissingIsNamed() {
    QFETCH(QStringList, path);
    const std::string said = refusal(englishWith(path, QJsonValue::Undefined));
    const std::string place = ": $." + path.join(QLatin1Char('.')).toStdString() + ": missing: expected ";
    QVERIFY2(said.starts_with("translations/words/xx.json:") && said.find(place) != std::string::npos,
             said.c_str());
}

void TestLanguageWords::otherFaultsAreNamed() {
    const auto says = [](const QByteArray& json, const char* words) {
        return refusal(json).find(words) != std::string::npos;
    };
    QVERIFY(refusal(fileOf("en")).empty());
    QVERIFY(says(englishWith({"roster", "roles", "trainee"}, QJsonArray()),
                 "$.roster.roles.trainee: an array of 0"));
    QVERIFY(says(englishWith({"roster", "roles", "trainee"}, "trainee"), "expected an array"));
    QVERIFY(says(englishWith({"claims", "second"}, QJsonArray{"s"}), "did you mean \"seconds\"?"));
    QVERIFY(says(englishWith({"pilot_prefix"}, QString()), "$.pilot_prefix"));
    QVERIFY(says("{", "expected JSON"));
}

QTEST_GUILESS_MAIN(TestLanguageWords)
#include "test_language_words.moc"
