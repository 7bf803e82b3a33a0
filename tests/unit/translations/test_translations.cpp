// SPDX-License-Identifier: GPL-3.0-or-later
// Every text that a person reads is translated, whole and in the form that the program relies on; none can be
// forgotten, because lupdate reads the sources again here.
#include "core/languages.h"
#include "support/feeling_words.h"
#include "unit/translations/content_sentences.h"
#include "unit/translations/glossary_stems.h"
#include "unit/translations/text_rules.h"

#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

using namespace chiron::test;

namespace {

/// Every language of the program has a catalogue, English for what is counted.
QStringList locales() {
    QStringList ids;
    for (const std::string& id : chiron::core::languageIds())
        ids << QString::fromStdString(id);
    return ids;
}
constexpr int kPluralForms = 2; ///< German, Greek and English alike: one, and any other number

QString catalogue(const QString& locale) {
    return QStringLiteral(CHIRON_SOURCE_DIR "/translations/chiron_%1.ts").arg(locale);
}

TsMessage text(const char* source, const char* translation) {
    TsMessage message;
    message.source = QString::fromUtf8(source);
    message.translations << QString::fromUtf8(translation);
    message.finished = true;
    return message;
}

/// The contexts, without namespaces, of what people read while they work: training and studies.
const QStringList kAtWork{QStringLiteral("AnswerNote"),    QStringLiteral("AnswerPanel"),
                          QStringLiteral("ApexStage"),     QStringLiteral("BreakPanel"),
                          QStringLiteral("ControlBar"),    QStringLiteral("ControlGuide"),
                          QStringLiteral("ForceBar"),      QStringLiteral("ForceGauge"),
                          QStringLiteral("ForceWords"),    QStringLiteral("GateWords"),
                          QStringLiteral("GraspNote"),     QStringLiteral("GraspPanel"),
                          QStringLiteral("GraspWords"),    QStringLiteral("HeaderBar"),
                          QStringLiteral("InfoPanel"),     QStringLiteral("InsertionPanel"),
                          QStringLiteral("LevelFacts"),    QStringLiteral("LivePlot"),
                          QStringLiteral("Metrics"),       QStringLiteral("ParticipantSentences"),
                          QStringLiteral("PlacesView"),    QStringLiteral("ReadyCard"),
                          QStringLiteral("SidePanel"),     QStringLiteral("SoundSign"),
                          QStringLiteral("StageWords"),    QStringLiteral("StudyControls"),
                          QStringLiteral("TargetBar"),     QStringLiteral("TrainingScreen"),
                          QStringLiteral("TrainingWords"), QStringLiteral("TrialsScreen")};
/// Those of the exercise in which palpating is the name of the task.
const QStringList kOfPalpation{QStringLiteral("FindingsBox"),    QStringLiteral("FlatFingers"),
                               QStringLiteral("LeanDial"),       QStringLiteral("MapLegend"),
                               QStringLiteral("PalpationPanel"), QStringLiteral("PalpationWords")};

/// The bare names of the QObject classes of the desktop that live in a namespace.
QSet<QString> namespacedClasses() {
    static const QRegularExpression pattern(QStringLiteral("\\bclass (\\w+)[^;{]*\\{\\s*Q_OBJECT"));
    QSet<QString> names;
    for (QDirIterator it(QStringLiteral(CHIRON_SOURCE_DIR "/app"), {QStringLiteral("*.h")}, QDir::Files,
                         QDirIterator::Subdirectories);
         it.hasNext();) {
        QFile file(it.next());
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const QString source = QString::fromUtf8(file.readAll());
        if (!source.contains(QLatin1String("\nnamespace chiron::")))
            continue;
        for (auto match = pattern.globalMatch(source); match.hasNext();)
            names << match.next().captured(1);
    }
    return names;
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT
private slots:
    void rulesNoticeFaults_data() {
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("translation");
        QTest::addColumn<bool>("good");
        const auto row = [](const char* name, const char* source, const char* translation, bool good) {
            QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(translation) << good;
        };
        row("good", "%1 of %2: \"&Save\" …", "%2, davon %1: „&Sichern“ …", true);
        row("Greek question", "Leave?", "Έξοδος;", true);
        row("empty", "Save", "", false);
        row("only spaces", "Save", " ", false);
        row("placeholder lost", "%1 of %2", "%1 von 2", false);
        row("placeholder twice", "%1", "%1 %1", false);
        row("localised placeholder lost", "%L1", "%1", false);
        row("line break lost", "One\nTwo", "Eins Zwei", false);
        row("space lost", "Name: ", "Name:", false);
        row("ellipsis lost", "End …", "Ende", false);
        row("full stop too many", "Saved", "Gespeichert.", false);
        row("full stop within quotation marks", "Say \"yes.\"", "Sagen Sie „ja“.", true);
        row("mnemonic lost", "&Save", "Sichern", false);
        row("mnemonic escaped", "Force && torque", "Kraft && Moment", true);
    }
    void rulesNoticeFaults() {
        QFETCH(QString, source);
        QFETCH(QString, translation);
        QFETCH(bool, good);
        const QStringList faults =
            faultsOf(text(source.toUtf8().constData(), translation.toUtf8().constData()), kPluralForms);
        QVERIFY2(faults.isEmpty() == good, qPrintable(faults.join(QLatin1String("; "))));
    }

    /// CMake, which makes the files of each language part of the program, reads the same list.
    void theBuildKnowsTheLanguages() {
        QCOMPARE(QStringLiteral(CHIRON_LANGUAGES).split(QLatin1Char(':')), locales());
    }

    void rulesNoticeUnfinishedAndMissingForms() {
        TsMessage message = text("%n days", "%n Tage");
        message.counts = true;
        QCOMPARE(faultsOf(message, kPluralForms).size(), 1);
        message.translations.prepend(QStringLiteral("%n Tag"));
        QVERIFY(faultsOf(message, kPluralForms).isEmpty());
        message.finished = false;
        QCOMPARE(faultsOf(message, kPluralForms).size(), 1);
        message.finished = true;
        message.translations[0].clear();
        QCOMPARE(faultsOf(message, kPluralForms).size(), 1);
    }

    void everyTextIsTranslated_data() { eachLocale(); }
    void everyTextIsTranslated() {
        QFETCH(QString, locale);
        const auto messages = readTs(catalogue(locale));
        QVERIFY(messages.has_value());
        QVERIFY(!messages->empty());
        QStringList faults;
        for (const TsMessage& message : *messages)
            for (const QString& fault : faultsOf(message, kPluralForms))
                faults << message.key() + QLatin1String(" -- ") + fault;
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
    }

    void noTextIsForgotten_data() { eachLocale(); }
    void noTextIsForgotten() {
        QFETCH(QString, locale);
        QTemporaryDir folder;
        QVERIFY(folder.isValid());
        const QString copy = folder.filePath(QStringLiteral("chiron_%1.ts").arg(locale));
        QVERIFY(QFile::copy(catalogue(locale), copy));
        QVERIFY(QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY2(update(copy, locale), "lupdate did not run");
        const auto known = readTs(catalogue(locale));
        const auto found = readTs(copy);
        QVERIFY(known.has_value() && found.has_value());
        QSet<QString> keys;
        for (const TsMessage& message : *known)
            keys << message.key();
        QStringList forgotten;
        for (const TsMessage& message : *found)
            if (!keys.contains(message.key()))
                forgotten << message.key();
        QVERIFY2(forgotten.isEmpty(), qPrintable(report(forgotten)));
    }

    /// tr() asks for the name with its namespace; a text filed under the bare name is never shown.
    void textsAreFiledWhereTheProgramAsks_data() { eachLocale(); }
    void textsAreFiledWhereTheProgramAsks() {
        QFETCH(QString, locale);
        const auto messages = readTs(catalogue(locale));
        QVERIFY(messages.has_value());
        const QSet<QString> classes = namespacedClasses();
        QVERIFY(classes.contains(QStringLiteral("MainWindow")));
        QStringList misfiled;
        for (const TsMessage& message : *messages)
            if (classes.contains(message.context))
                misfiled << message.key();
        QVERIFY2(misfiled.isEmpty(), qPrintable(report(misfiled)));
    }

    /// A text that is a term by itself reads as docs/glossary.md has it, on every screen.
    void termsAreTheGlossarys_data() { inTranslation(); }
    void termsAreTheGlossarys() {
        QFETCH(QString, locale);
        QFETCH(int, cell);
        QHash<QString, QStringList> terms;
        for (const QStringList& cells : glossary())
            for (const QString& term : formsIn(cells[0]))
                terms[term] << formsIn(cells[cell]);
        QVERIFY(terms.size() > 60);
        const auto messages = readTs(catalogue(locale));
        QVERIFY(messages.has_value());
        QStringList others;
        int checked = 0;
        for (const TsMessage& message : *messages) {
            const auto found = terms.constFind(message.source.trimmed().toLower());
            if (found == terms.constEnd())
                continue;
            ++checked;
            if (!found->contains(message.translations.value(0).trimmed().toLower()))
                others << QStringLiteral("%1: \"%2\", in the glossary \"%3\"")
                              .arg(message.key(), message.translations.value(0),
                                   found->join(QStringLiteral(", ")));
        }
        QVERIFY2(others.isEmpty(), qPrintable(report(others)));
        QVERIFY(checked > 20);
    }

    /// Terms within sentences are recognised by stems; they and the glossary belong together.
    void everyTermHasStems() {
        QStringList faults;
        const GlossaryStems stems(stemsFile(), faults);
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
        QStringList inGlossary;
        for (const QStringList& cells : glossary())
            for (const QString& form : formsIn(cells[0])) {
                inGlossary << form;
                for (int cell = 1; cell < locales().size(); ++cell)
                    if (!stems.has(form, cells[cell], locales()[cell]))
                        faults << QStringLiteral("%1: no stem of \"%2\"").arg(form, cells[cell].trimmed());
            }
        for (const QString& term : stems.firstForms())
            if (!inGlossary.contains(term.toLower()))
                faults << term + QStringLiteral(": not in the glossary");
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
    }

    void stemsNoticeOtherWords_data() {
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("translation");
        QTest::addColumn<QStringList>("missing");
        const auto row = [](const char* name, const char* source, const char* translation,
                            const QStringList& missing) {
            QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(translation) << missing;
        };
        row("the term", "Lift the tool.", "Heben Sie das Instrument an.", {});
        row("another word", "Lift the tool.", "Heben Sie das Werkzeug an.", {QStringLiteral("tool")});
        row("plural", "Two tools", "Zwei Werkzeuge", {QStringLiteral("tool")});
        row("large letters", "Trial 2", "Versuch 2", {QStringLiteral("trial")});
        row("inside of a German word", "Force limit", "Kraftgrenze", {});
        row("part of another word", "Enforced limits", "Erzwungene Grenzen", {});
        row("in a longer term", "Pass mark: 3", "Bestehensgrenze: 3", {});
        row("in a longer term and by itself", "Mark it. Pass mark: 3", "Los. Bestehensgrenze: 3",
            {QStringLiteral("mark")});
        row("words with another meaning", "In quotation marks", "In Anführungszeichen", {});
        row("two", "The tool of a trial", "Das Werkzeug eines Versuchs",
            {QStringLiteral("trial"), QStringLiteral("tool")});
    }
    void stemsNoticeOtherWords() {
        QFETCH(QString, source);
        QFETCH(QString, translation);
        QFETCH(QStringList, missing);
        QStringList faults;
        GlossaryStems stems(stemsFile(), faults);
        QCOMPARE(stems.missingIn({QStringLiteral("a place"), source, translation}, QStringLiteral("de")),
                 missing);
    }

    /// Every sentence that has a term in English has it in the translation: the catalogues and the content.
    void sentencesHaveTheTerms_data() { inTranslation(); }
    void sentencesHaveTheTerms() {
        QFETCH(QString, locale);
        QStringList faults;
        GlossaryStems stems(stemsFile(), faults);
        const std::vector<Sentence> sentences = everySentence(locale, faults);
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
        for (const Sentence& sentence : sentences)
            for (const QString& term : stems.missingIn(sentence, locale))
                faults << QStringLiteral("%1 is missing in %2: \"%3\" \"%4\"")
                              .arg(term, sentence.place, sentence.source, sentence.translation);
        for (const QString& exception : stems.unused(locale))
            faults << QStringLiteral("an exception that nothing needs: ") + exception;
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
        QVERIFY2(stems.found() > 2000, qPrintable(QString::number(stems.found())));
    }

    /// A key has one name in each language: that of the lists of shortcuts, in which Qt names a key where the
    /// program does not.
    void keysHaveOneName_data() { inTranslation(); }
    void keysHaveOneName() {
        QFETCH(QString, locale);
        static const QRegularExpression otherNames(QStringLiteral(
            "\\b(PageUp|PageDown|PgUp|PgDown|PgDn|Escape|Spacebar|[Ss]pace bar|Del|Return)\\b"));
        // In the middle of a sentence or in brackets: as first words these are verbs.
        static const QString notFirst = QStringLiteral("(?<=[a-z,:] |\\()%1\\b");
        QHash<QString, QRegularExpression> patterns;
        for (const char* key : {"Enter", "Delete", "Shift"})
            patterns[QLatin1String(key)] = QRegularExpression(notFirst.arg(QLatin1String(key)));
        for (const char* key : {"Esc", "Space", "Backspace", "Tab", "Ctrl", "Alt", "Page Up", "Page Down"})
            patterns[QLatin1String(key)] =
                QRegularExpression(QStringLiteral("\\b%1\\b").arg(QLatin1String(key)));
        QStringList faults;
        const std::vector<Sentence> sentences = everySentence(locale, faults);
        QHash<QString, QString> names;
        const QString qtsNames = QStringLiteral("QShortcut"), ownNames = QStringLiteral("KeyNames");
        for (const QString& context : {qtsNames, ownNames})
            for (const Sentence& sentence : sentences)
                if (sentence.place == context)
                    names[sentence.source] = sentence.translation;
        int checked = 0;
        for (const Sentence& sentence : sentences) {
            if (sentence.place == qtsNames)
                continue;
            if (const auto other = otherNames.match(sentence.source); other.hasMatch())
                faults << QStringLiteral("%1 in %2: \"%3\"")
                              .arg(other.captured(), sentence.place, sentence.source);
            for (auto key = patterns.cbegin(); key != patterns.cend(); ++key) {
                if (!sentence.source.contains(key.value()))
                    continue;
                ++checked;
                const QString name = names.value(key.key());
                if (name.isEmpty() || !sentence.translation.contains(name))
                    faults << QStringLiteral("%1 is not \"%2\" in %3: \"%4\" \"%5\"")
                                  .arg(key.key(), name, sentence.place, sentence.source,
                                       sentence.translation);
            }
        }
        for (const auto& [qts, own] :
             {std::pair{"PgUp", "Page Up"}, {"PgDown", "Page Down"}, {"Del", "Delete"}, {"Return", "Enter"}})
            if (names.value(QLatin1String(qts)) != names.value(QLatin1String(own)))
                faults << QStringLiteral("%1 has two names").arg(QLatin1String(own));
        QVERIFY2(faults.isEmpty(), qPrintable(report(faults)));
        QVERIFY2(checked > 50, qPrintable(QString::number(checked)));
    }

    /// Where force is shown and not felt, no text at work may speak of feeling. The pairs that differ between
    /// the two stand in FeltWords, which says nothing but the one that fits.
    void textsAtWorkDoNotSpeakOfFeeling_data() { eachLocale(); }
    void textsAtWorkDoNotSpeakOfFeeling() {
        QFETCH(QString, locale);
        // English texts are the sources in the catalogue of another language.
        const auto messages =
            readTs(catalogue(locale == QLatin1String("en") ? QStringLiteral("de") : locale));
        QVERIFY(messages.has_value());
        QSet<QString> seen;
        QStringList found;
        for (const TsMessage& message : *messages) {
            const QString context = message.context.section(QStringLiteral("::"), -1);
            const bool palpation = kOfPalpation.contains(context);
            if (!palpation && !kAtWork.contains(context))
                continue;
            seen << context;
            QStringList texts = message.translations;
            if (locale == QLatin1String("en"))
                texts = {message.source};
            for (const QString& text : texts)
                if (const QString words = chiron::tests::feelingIn(text, locale, palpation); !words.isEmpty())
                    found << message.key() + QStringLiteral(" -- ") + words;
        }
        QVERIFY2(found.isEmpty(), qPrintable(report(found)));
        for (const QString& context : kAtWork + kOfPalpation)
            QVERIFY2(seen.contains(context), qPrintable(context)); // a renamed screen would not be looked at
    }

    /// A text that lupdate does not see, because it is in a folder that it does not read, could never be
    /// translated.
    void everyFolderWithTextsIsRead() {
        static const QRegularExpression pattern(
            QStringLiteral("\\b(tr|translate|QT_TR_NOOP|QT_TRANSLATE_NOOP)\\(\""));
        const QStringList read = QStringLiteral(CHIRON_TRANSLATED_FOLDERS).split(QLatin1Char(':'));
        QStringList unread;
        for (const char* tree : {"/app", "/database", "/modules", "/curriculum"})
            for (QDirIterator it(QStringLiteral(CHIRON_SOURCE_DIR) + QLatin1String(tree),
                                 {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                                 QDirIterator::Subdirectories);
                 it.hasNext();) {
                const QString path = it.next();
                const bool covered = std::any_of(read.begin(), read.end(), [&](const QString& one) {
                    return path.startsWith(one + QLatin1Char('/'));
                });
                QFile file(path);
                if (!covered && file.open(QIODevice::ReadOnly) &&
                    QString::fromUtf8(file.readAll()).contains(pattern))
                    unread << path;
            }
        QVERIFY2(unread.isEmpty(), qPrintable(report(unread)));
    }

private:
    static void eachLocale() {
        QTest::addColumn<QString>("locale");
        for (const QString& locale : locales())
            QTest::newRow(qPrintable(locale)) << locale;
    }

    static void inTranslation() {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<int>("cell"); // of the glossary, whose columns are in the order of the languages
        for (int cell = 1; cell < locales().size(); ++cell)
            QTest::newRow(qPrintable(locales()[cell])) << locales()[cell] << cell;
    }

    /// The texts of the content and of the catalogue, with every form of those that count. Faults: what
    /// cannot be read.
    static std::vector<Sentence> everySentence(const QString& locale, QStringList& faults) {
        std::vector<Sentence> sentences =
            contentSentences(QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content"), locale, faults);
        if (sentences.size() <= 400)
            faults << QStringLiteral("only %1 texts of the content").arg(sentences.size());
        const auto messages = readTs(catalogue(locale));
        if (!messages)
            faults << catalogue(locale) + QStringLiteral(": cannot be read");
        else
            for (const TsMessage& message : *messages)
                for (const QString& translation : message.translations)
                    sentences.push_back({message.context, message.source, translation});
        return sentences;
    }

    static QString stemsFile() {
        return QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/translations/glossary_stems.txt");
    }

    /// The rows of the glossary: a cell for each language, English first.
    static std::vector<QStringList> glossary() {
        QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/docs/glossary.md"));
        if (!file.open(QIODevice::ReadOnly))
            qFatal("the glossary cannot be read");
        std::vector<QStringList> rows;
        for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
            const QStringList cells = line.split(QLatin1Char('|')).mid(1, locales().size());
            if (cells.size() == locales().size() && !line.startsWith(QLatin1String("|---")) &&
                cells[0].trimmed() != QLatin1String("English"))
                rows.push_back(cells);
        }
        return rows;
    }

    /// The forms in a cell, without what stands in brackets, in small letters.
    static QStringList formsIn(QString cell) {
        static const QRegularExpression brackets(QStringLiteral("\\([^)]*\\)"));
        QStringList forms;
        for (const QString& form : cell.remove(brackets).split(QLatin1Char(',')))
            if (const QString plain = form.trimmed().toLower(); !plain.isEmpty())
                forms << plain;
        return forms;
    }

    static QString report(const QStringList& lines) {
        constexpr int kShown = 30;
        return QStringLiteral("%1:\n%2").arg(lines.size()).arg(lines.mid(0, kShown).join(QLatin1Char('\n')));
    }

    /// As the target update_translations does it.
    static bool update(const QString& path, const QString& locale) {
        QStringList arguments{QStringLiteral("-silent"),
                              QStringLiteral("-locations"),
                              QStringLiteral("none"),
                              QStringLiteral("-no-obsolete"),
                              QStringLiteral("-no-ui-lines"),
                              QStringLiteral("-I"),
                              QStringLiteral(CHIRON_SOURCE_DIR),
                              QStringLiteral("-I"),
                              QStringLiteral(CHIRON_SOURCE_DIR "/app")};
        if (locale == QLatin1String("en"))
            arguments << QStringLiteral("-pluralonly");
        arguments << QStringLiteral(CHIRON_TRANSLATED_FOLDERS).split(QLatin1Char(':'))
                  << QStringLiteral("-ts") << path;
        QProcess lupdate;
        lupdate.start(QStringLiteral(CHIRON_LUPDATE), arguments);
        constexpr int kLimitMs = 120'000;
        return lupdate.waitForFinished(kLimitMs) && lupdate.exitStatus() == QProcess::NormalExit &&
               lupdate.exitCode() == 0;
    }
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "test_translations.moc"
