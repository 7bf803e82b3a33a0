// SPDX-License-Identifier: GPL-3.0-or-later
// The instruments that come with the program, and what a study keeps of them.
#include "catalogue/instrument_catalogue.h"
#include "catalogue/study_json.h"
#include "core/languages.h"
#include "psychophysics/measures/instrument_score.h"
#include "study_samples.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using psychophysics::Questionnaire;

namespace {

const catalogue::Instrument* find(const std::vector<catalogue::Instrument>& all, const std::string& id) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.questionnaire.id == id; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace

class TestInstruments : public QObject {
    Q_OBJECT
private slots:
    void eachSaysWhoseItIs() {
        const auto all = catalogue::loadInstruments();
        QVERIFY2(all.has_value(), all ? "" : all.error().message.c_str());
        for (const char* id : {"sus", "nasa_tlx", "nasa_tlx_weighted", "edinburgh", "enrolment"})
            QVERIFY2(find(*all, id), id);
        for (const catalogue::Instrument& each : *all) {
            QVERIFY2(each.source.size() > 10 && each.permission.size() > 10, each.questionnaire.id.c_str());
            for (const std::string& language : core::languageIds()) {
                QVERIFY2(each.questionnaire.title.count(language) == 1, each.questionnaire.id.c_str());
                for (const auto& item : each.questionnaire.items)
                    QVERIFY2(item.text.count(language) == 1, item.id.c_str());
            }
            QCOMPARE(psychophysics::scoreFault(each.questionnaire), std::string());
            QCOMPARE(each.questionnaire.score.empty(), each.questionnaire.id == "enrolment");
        }
        QVERIFY(find(*all, "enrolment")->questionnaire.when == Questionnaire::When::enrolment);
    }

    /// In a frozen design they are whole: nothing of a later version of the files changes a study.
    void aStudyKeepsThem() {
        const auto all = catalogue::loadInstruments();
        auto study = catalogue::readStudy(test::someStudy(), "study");
        QVERIFY2(study.has_value(), study ? "" : study.error().message.c_str());
        study->questionnaires.clear();
        for (const catalogue::Instrument& each : *all)
            study->questionnaires.push_back(each.questionnaire);
        const auto again = catalogue::readStudy(catalogue::studyJson(*study), "again");
        QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
        QCOMPARE(again->questionnaires.size(), all->size());
        for (std::size_t i = 0; i < all->size(); ++i) {
            QCOMPARE(again->questionnaires[i].score, study->questionnaires[i].score);
            QVERIFY(again->questionnaires[i].when == study->questionnaires[i].when);
        }
        QCOMPARE(catalogue::studyJson(*again), catalogue::studyJson(*study));
    }

    void aScoreThatCannotBeMadeIsAFault() {
        auto study = catalogue::readStudy(test::someStudy(), "study");
        QVERIFY(study);
        const auto all = catalogue::loadInstruments();
        study->questionnaires = {find(*all, "sus")->questionnaire};
        study->questionnaires[0].items.pop_back();
        const auto read = catalogue::readStudy(catalogue::studyJson(*study), "study");
        QVERIFY(!read);
        QVERIFY2(read.error().message.find("ten statements") != std::string::npos,
                 read.error().message.c_str());
    }

    void aFolderWithoutInstrumentsHasNone() {
        QTemporaryDir folder;
        const auto none = catalogue::loadInstruments(folder.path().toStdString());
        QVERIFY(none && none->empty());
    }
};

QTEST_GUILESS_MAIN(TestInstruments)
#include "test_instruments.moc"
