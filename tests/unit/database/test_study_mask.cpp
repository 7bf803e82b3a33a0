// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "catalogue/study_json.h"
#include "database/repositories/study_blinding.h"
#include "database/repositories/study_mask.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// The design of a blinded study, as those read it who may not know its conditions.
class TestStudyMask : public QObject {
    Q_OBJECT
private slots:
    void init();
    void designIsMasked();
    void unlikeConditionsAreMaskedWholly();
    void wideTablesStayReadable();

private:
    template <class Job> auto as(const Actor& actor, Job job) {
        return m->database->write([&](WriteContext& w) {
            StudyRepository studies(w.connection(), actor);
            return job(studies);
        });
    }
    std::string code(const std::string& condition) {
        auto connection = m->database->openReader();
        return codeOf(**connection, m_of.frozen, condition);
    }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous(), m_ruth = Actor::anonymous(), m_rob = Actor::anonymous();
    StudyTargets m_of; ///< ruth's
};

void TestStudyMask::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_ruth = m->person(m_admin, "ruth", {Role::researcher}).value();
    m_rob = m->person(m_admin, "rob", {Role::researcher}).value();
    const auto made = makeStudies(*m->database, m_ruth, "blinded");
    REQUIRE(made);
    m_of = *made;
}

// Who may not look up which code is which reads codes instead of conditions, and what all of them share; who
// conducts a run gets it whole.
void TestStudyMask::designIsMasked() {
    auto connection = m->database->openReader();
    const auto read = [&](const Actor& actor, StudyNumber study) {
        return StudyReader(**connection, actor).study(study).value();
    };
    const std::string frozen = read(m_ruth, m_of.frozen).designJson;
    for (const Actor& actor : {m_ruth, m_admin}) {
        QVERIFY(!read(actor, m_of.frozen).masked &&
                read(actor, m_of.frozen).designJson.find("hard") != std::string::npos);
    }
    const StudyRecord record = read(m_rob, m_of.frozen);
    QVERIFY(record.masked && record.blinding.on && !record.blinding.oneStimulus);
    for (const char* told : {"hard", "soft", "200", "800"}) {
        QVERIFY2(record.designJson.find(told) == std::string::npos, told);
    }
    const auto design = catalogue::readStudy(QByteArray::fromStdString(record.designJson), "masked");
    REQUIRE(design);
    const auto codes = StudyReader(**connection, m_rob).conditionCodes(m_of.frozen).value();
    QCOMPARE(design->conditions.size(), codes.size());
    for (std::size_t i = 0; i < codes.size();
         ++i) { // by code, not in the design's order; alike in all but that
        const psychophysics::Condition& each = design->conditions[i];
        QCOMPARE(each.title.at("en"), codes[i].sealedCode);
        QVERIFY(each.stimulus.reference == design->conditions.front().stimulus.reference &&
                each.task == psychophysics::Task::rank3);
        QVERIFY((each.stimulus.differences == std::vector<double>{0.02, 0.05, 0.1}) &&
                each.procedures.size() == 1);
    }
    QVERIFY(read(m_rob, m_of.draft).designJson.find("hard") !=
            std::string::npos); // a draft is not blinded yet
    const auto run = as(m_rob, [&](StudyRepository& s) { return s.conductRun(m_of.ready, code("soft")); });
    REQUIRE(run);
    QCOMPARE(run->designJson, frozen);
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "all are done"); }));
    QVERIFY(!read(m_rob, m_of.frozen).masked && read(m_rob, m_of.frozen).designJson == frozen);
}

// Where tasks, tables or procedures differ nothing of them is left; of an apex that it is one.
void TestStudyMask::unlikeConditionsAreMaskedWholly() {
    const std::vector<SealedCondition> codes{{"", "K2P"}, {"", "Q7M"}};
    const auto masked = [&](const std::string& design) {
        const auto json = maskedDesign(design, blindingOf(design, false).value(), codes);
        return json ? catalogue::readStudy(QByteArray::fromStdString(*json), "masked")
                    : tl::unexpected(json.error());
    };
    std::string design = someDesign("unlike");
    const std::string table = "[0.02,0.05,0.1]}";
    design.replace(design.rfind(table), table.size(), "[0.02,0.05,0.2]}");
    const auto tables = masked(design);
    REQUIRE(tables);
    for (const psychophysics::Condition& each : tables->conditions) {
        QVERIFY(each.stimulus.differences.size() == 1 && each.task == psychophysics::Task::twoAfc &&
                each.stimulus.attribute != psychophysics::Attribute::stiffness);
    }
    std::string spheres = someDesign("spheres");
    for (const auto& [reference, radius] :
         {std::pair<std::string, std::string>{"200", "0.02"}, {"800", "0.03"}}) {
        const std::string stimulus =
            R"("attribute":"stiffness","reference":)" + reference +
            R"(,"differences":[0.02,0.05,0.1]},"task":"rank3","procedures":[{"kind":"descending","levels":[0.1,0.05,0.02]}])";
        spheres.replace(
            spheres.find(stimulus), stimulus.size(),
            R"("attribute":"apex","reference":)" + radius +
                R"(,"differences":[0.1]},"task":"adjustment","procedures":[{"kind":"constant","levels":[0.1],"repeats":3}])");
    }
    const auto apexes = masked(spheres);
    REQUIRE(apexes);
    for (const psychophysics::Condition& each : apexes->conditions) {
        QVERIFY(each.stimulus.attribute == psychophysics::Attribute::apex && each.stimulus.reference < 0.02 &&
                each.procedures.size() == 1);
    }
    QCOMPARE(maskedDesign("{}", {}, codes).error().code,
             core::ErrorCode::badInput); // what does not read shows nothing
}

// The neutral reference leaves room for the largest object of a ranking, with ties or without: 0, D and 2D
// above it.
void TestStudyMask::wideTablesStayReadable() {
    const std::vector<SealedCondition> codes{{"", "K2P"}, {"", "Q7M"}};
    for (const std::string task : {"rank3", "rank3_ties"}) {
        std::string design = someDesign("wide");
        for (const auto& [from, to] : {std::pair<std::string, std::string>{"0.1]}", "1.8]}"},
                                       {"200", "3"},
                                       {"800", "4"},
                                       {"\"rank3\"", "\"" + task + "\""},
                                       {"[0.1,", "[1.8,"}}) {
            for (std::size_t at = design.find(from); at != std::string::npos;
                 at = design.find(from, at + to.size())) {
                design.replace(at, from.size(), to);
            }
        }
        REQUIRE(catalogue::readStudy(QByteArray::fromStdString(design), "design"));
        const auto masked = maskedDesign(design, blindingOf(design, false).value(), codes);
        REQUIRE(masked);
        REQUIRE(catalogue::readStudy(QByteArray::fromStdString(*masked), "masked"));
    }
}

QTEST_GUILESS_MAIN(TestStudyMask)
#include "test_study_mask.moc"
