// SPDX-License-Identifier: GPL-3.0-or-later
// The preview of a design as a researcher uses it: assumptions of a comparison as fields, what they do to
// what is told, errors beside figures.
#include "desktop/studies/preview_page.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/languages.h"
#include "support/made_study.h"
#include "support/patience.h"
#include "support/screen_outline.h"
#include "support/settled.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSpinBox>
#include <cmath>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {
constexpr int kRuns = 6;

/// Short, so that it is simulated soon.
psychophysics::StudyDesign twoConditions() {
    psychophysics::StudyDesign design = tests::smallStudy("two");
    for (psychophysics::Condition& condition : design.conditions)
        for (psychophysics::ProcedureSpec& procedure : condition.procedures)
            std::get<psychophysics::Rank3Spec>(procedure).stop.trials = 14;
    return design;
}
} // namespace

class TestPreviewPage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_site = std::make_unique<tests::DesktopFixture>();
        m_site->logIn("rhea");
    }
    void cleanup() { m_page.reset(); }
    void cleanupTestCase() { m_site.reset(); }
    void aComparisonHasItsAssumptions();
    void whatIsAssumedDecidesWhatIsFound();
    void theCurveHasItsErrors();
    void oneConditionComparesNothing();
    void isMadeAsItWas();
    void itsWordsFit();

private:
    void show(const psychophysics::StudyDesign& design) {
        m_draft.load(design);
        m_page = std::make_unique<desktop::PreviewPage>(
            desktop::DesignPage{m_site->context, m_draft, false, QStringLiteral("en"), {}, false});
        find<QSpinBox>("preview.runs")->setValue(kRuns);
    }
    template <class Widget> Widget* find(const char* name) const {
        return m_page->findChild<Widget*>(QLatin1String(name));
    }
    void preview() {
        find<QPushButton>("preview.start")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->findChildren<QFrame*>(QStringLiteral("preview.result")).isEmpty(),
                                 kPatience_ms);
    }
    QList<QLabel*> detectable() const {
        return m_page->findChildren<QLabel*>(QStringLiteral("preview.detectable"));
    }
    QStringList texts() const {
        QStringList all;
        for (const QLabel* label : m_page->findChildren<QLabel*>())
            all << label->text();
        return all;
    }
    QString ratioText(double ratio, double error) const {
        return QStringLiteral("× %1").arg(
            desktop::study_words::withError(ratio, error, m_site->context.locale()));
    }

    std::unique_ptr<tests::DesktopFixture> m_site;
    desktop::StudyDraft m_draft;
    std::unique_ptr<desktop::PreviewPage> m_page;
};

void TestPreviewPage::aComparisonHasItsAssumptions() {
    show(twoConditions());
    const psychophysics::PowerQuestion usual;
    QCOMPARE(find<QCheckBox>("preview.paired")->isChecked(), usual.paired);
    QCOMPARE(find<QSpinBox>("preview.participants")->value(), 6); // as the design plans
    // Spreads in per cent: 0.05 and 0.15 of a logarithm are factors of 1.122 and 1.413.
    QCOMPARE(usual.effectSdLog10, 0.05);
    QCOMPARE(usual.personSdLog10, 0.15);
    QCOMPARE(find<QDoubleSpinBox>("preview.effect_sd")->value(), 12.2);
    QCOMPARE(find<QDoubleSpinBox>("preview.person_sd")->value(), 41.3);
    for (const char* field : {"preview.effect_sd", "preview.person_sd"})
        QCOMPARE(find<QDoubleSpinBox>(field)->suffix().trimmed(), QStringLiteral("%"));
    QCOMPARE(find<QDoubleSpinBox>("preview.alpha")->value(), 100.0 * usual.alpha);
    QCOMPARE(find<QDoubleSpinBox>("preview.power")->value(), 80.0);
    // Which spread counts follows from who does what.
    QVERIFY(find<QDoubleSpinBox>("preview.effect_sd")->isEnabled() &&
            !find<QDoubleSpinBox>("preview.person_sd")->isEnabled());
    find<QCheckBox>("preview.paired")->click();
    QVERIFY(!find<QDoubleSpinBox>("preview.effect_sd")->isEnabled() &&
            find<QDoubleSpinBox>("preview.person_sd")->isEnabled());
    find<QDoubleSpinBox>("preview.alpha")->setValue(0.0);
    QVERIFY(find<QDoubleSpinBox>("preview.alpha")->value() > 0.0); // no level of 0 %
    find<QSpinBox>("preview.participants")->setValue(1);
    QCOMPARE(find<QSpinBox>("preview.participants")->value(), 2);
}

void TestPreviewPage::whatIsAssumedDecidesWhatIsFound() {
    const psychophysics::StudyDesign design = twoConditions();
    show(design);
    preview();
    QCOMPARE(m_page->findChildren<QFrame*>(QStringLiteral("preview.result")).size(), 2);
    const QList<QLabel*> labels = detectable();
    QCOMPARE(labels.size(), 2);
    std::vector<double> runSd, runSdError; // the same runs, asked for without the screen
    for (std::size_t i = 0; i < design.conditions.size(); ++i) {
        const auto result = desktop::previewCondition(design, i, {.weber = 0.1, .lapse = 0.02}, kRuns,
                                                      [](double) { return true; });
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        runSd.push_back(result->plan.sdLog10);
        runSdError.push_back(result->plan.sdError);
    }
    psychophysics::PowerQuestion question;
    question.participants = 6;
    double wanted = 0.8;
    const auto told = [&] {
        for (std::size_t i = 0; i < runSd.size(); ++i) {
            question.runSdLog10 = runSd[i];
            const auto smallest = [&](const psychophysics::PowerQuestion& asked) {
                return psychophysics::detectableRatio(asked, wanted);
            };
            const double ratio = smallest(question);
            const double error = psychophysics::figureError(question, runSdError[i], smallest);
            if (labels[static_cast<int>(i)]->text() !=
                (std::isfinite(ratio) ? ratioText(ratio, error) : QStringLiteral("none up to × 10")))
                return QStringLiteral("%1 instead of %2").arg(labels[static_cast<int>(i)]->text()).arg(ratio);
        }
        return QString();
    };
    QCOMPARE(told(), QString());
    const auto after = [&](const char* field, double value) { find<QDoubleSpinBox>(field)->setValue(value); };
    const QString before = labels[0]->text();
    QVERIFY2(before.contains(QStringLiteral(" ± ")), qPrintable(before));
    after("preview.alpha", 0.1);
    question.alpha = 0.001;
    QCOMPARE(told(), QString());
    QVERIFY(labels[0]->text() != before); // and nothing is simulated again: the same labels
    after("preview.power", 95.0);
    wanted = 0.95;
    QCOMPARE(told(), QString());
    after("preview.effect_sd", 58.5);
    question.effectSdLog10 = std::log10(1.585);
    QCOMPARE(told(), QString());
    after("preview.person_sd", 151.2); // of people who do both nothing changes
    QCOMPARE(told(), QString());
    find<QCheckBox>("preview.paired")->click();
    question.paired = false;
    question.personSdLog10 = std::log10(2.512);
    QCOMPARE(told(), QString());
    find<QSpinBox>("preview.participants")->setValue(2);
    question.participants = 2;
    QCOMPARE(told(), QString());
    QCOMPARE(labels[0]->text(), QStringLiteral("none up to × 10"));
    // What is assumed stands in the words beside the number, and every figure has its Monte Carlo error.
    QVERIFY(!texts().filter(QStringLiteral("and two groups of 2 participants")).isEmpty());
    int errors = 0;
    for (const QString& text : texts())
        errors += text.contains(QStringLiteral(" ± ")) ? 1 : 0;
    QCOMPARE(errors, 2 * 5);
    QVERIFY(!texts().filter(QStringLiteral("±: one standard error")).isEmpty());
}

/// Of the curve, too: of its middle and of both ends of its band, at every number of trials.
void TestPreviewPage::theCurveHasItsErrors() {
    const psychophysics::StudyDesign design = twoConditions();
    const auto result = desktop::previewCondition(design, 0, {.weber = 0.1, .lapse = 0.02}, kRuns,
                                                  [](double) { return true; });
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    QVERIFY(result->curve.size() >= 3);
    for (const desktop::PreviewPoint& point : result->curve)
        QVERIFY(point.weberError > 0.0 && point.lowError > 0.0 && point.highError > 0.0);
    show(design);
    preview();
    // A plot has no meta-object of its own.
    const auto* plot = dynamic_cast<report::PlotView*>(find<QWidget>("preview.plot"));
    QVERIFY(plot && plot->legendTexts().contains(QStringLiteral("± one standard error")));
    QCOMPARE(plot->legendTexts().filter(QStringLiteral("standard error")).size(), 1);
}

void TestPreviewPage::oneConditionComparesNothing() {
    psychophysics::StudyDesign design = twoConditions();
    design.conditions.resize(1);
    show(design);
    for (const char* field : {"preview.paired", "preview.participants", "preview.effect_sd",
                              "preview.person_sd", "preview.alpha", "preview.power"})
        QVERIFY2(!find<QWidget>(field), field);
    preview();
    QVERIFY(detectable().isEmpty());
}

/// Its fields and what they come to, against what was read and kept: CHIRON_STORE_OUTLINES=1
/// QT_QPA_PLATFORM=offscreen build/release/tests/gui/studies/test_preview_page
void TestPreviewPage::isMadeAsItWas() {
    tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_preview.txt"));
    QStringList different;
    for (const std::size_t conditions : {2U, 1U}) {
        psychophysics::StudyDesign design = twoConditions();
        design.conditions.resize(conditions);
        show(design);
        preview();
        QTRY_VERIFY_WITH_TIMEOUT(m_site->context.background().idle(), kPatience_ms);
        different << kept.differs(QStringLiteral("%1 conditions").arg(conditions),
                                  tests::ScreenOutline::of(*m_page));
    }
    different.removeAll(QString());
    QVERIFY2(different.isEmpty(), qPrintable(different.join(QLatin1Char('\n'))));
    QCOMPARE(kept.unseen(), QStringList());
}

void TestPreviewPage::itsWordsFit() {
    QStringList findings;
    std::vector<std::pair<const char*, double>> looks;
    for (const char* language : tests::otherLanguages())
        looks.emplace_back(language, 2.0);
    looks.emplace_back("de", 1.0);
    for (const auto& [language, scale] : looks) {
        m_site->settings.setLanguage(QLatin1String(language));
        m_site->settings.setScale(scale);
        m_site->context.applyAppearance();
        show(twoConditions());
        preview();
        QScrollArea area; // as the screen shows it
        area.setWidgetResizable(true);
        area.resize(1000, 640);
        area.setWidget(m_page.release());
        area.show();
        for (const QString& finding : tests::settledFindings(&area))
            findings << QStringLiteral("%1 %2: %3").arg(QLatin1String(language)).arg(scale).arg(finding);
        if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty())
            area.widget()->grab().save(
                QStringLiteral("%1/preview_%2_%3.png").arg(folder, QLatin1String(language)).arg(scale));
    }
    m_site->settings.setLanguage(QStringLiteral("en"));
    m_site->settings.setScale(1.0);
    m_site->context.applyAppearance();
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestPreviewPage)
#include "test_preview_page.moc"
