// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the researcher's screens that need no site: forms, drafts, words.
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/questionnaire/questionnaire_form.h"
#include "desktop/studies/attribute_names.h"
#include "desktop/studies/difference_table.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/levels_table.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/number_list.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/preview_work.h"
#include "desktop/studies/procedure_form.h"
#include "desktop/studies/quantity_text.h"
#include "desktop/studies/study_draft.h"
#include "desktop/studies/study_titles.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/weight_check.h"
#include "desktop/study_data/replaced_folder.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/places_view.h"
#include "desktop/widgets/flow_layout.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "report/plot_view.h"
#include "session_report/study_warning_words.h"
#include "support/made_study.h"
#include "support/painted_shapes.h"
#include "support/patience.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <algorithm>
#include <qcustomplot.h>
#include <set>

#include <qcustomplot.h>

using namespace chiron;
using psychophysics::Task;

class TestStudyParts : public QObject {
    Q_OBJECT
private slots:
    void draftsAreUndone();
    void listsAreRead();
    void plainStudyReads();
    void everyUsualProcedureReads_data();
    void everyUsualProcedureReads();
    void anEarlierExportIsReplacedOrKept();
    void requiredItemsAreMissed();
    void previewKnowsItsObserver();
    void numbersWithUnits();
    void neighboursReadDifferently();
    void aTableOfLevelsTellsItsObjectsApart();
    void shortNamesAreMadeOfTitles();
    void namesFollowTheAttribute();
    void theUsualConsentIsNotShort();
    void rangesOfProceduresAreThoseThatAreTaken_data();
    void rangesOfProceduresAreThoseThatAreTaken();
    void controlsOfALineAreLevel();
    void experimentersAreBlindToForces();
    void oneProcedureNeedsNoLegend();
    void fieldsTakeNoMoreRoomThanTheyNeed();
    void intervalsAreNoHalves();
    void namesOfPlacesStandApart();
    void theForceBarMarksTheLimit();
    void theLineOfLettingGoStandsAtItsHeight();
    void quantitiesAreReadWithTheirUnits();
    void whatIsTypedIsTakenOrTold();
    void anEmptiedFieldIsNoZero();
    void soundAndForceAreCheckedBeforeFreezing();
    void whatIsToldBeforeFreezingSaysOfWhat();
    void aHeavyObjectIsAdvisedAgainst();
    void runsWithoutValuesAreToldBeforeFreezing();

private:
    desktop::Theme m_theme = *desktop::Theme::load(desktop::ThemeName::light, 1.0);
    QLocale m_locale{QLocale::English, QLocale::UnitedKingdom};
};

/// In a high window rows and cards stay together: what is left over is below all of them.
void TestStudyParts::fieldsTakeNoMoreRoomThanTheyNeed() {
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    auto* card = new QFrame;
    auto* inside = new QVBoxLayout(card);
    auto* grid = new desktop::FieldGrid(m_theme, m_locale, false);
    auto* first = grid->whole(QStringLiteral("First"), QStringLiteral("first"), 1, 0, 9, [](int) {});
    grid->longText(QStringLiteral("Words"), QStringLiteral("words"), {}, 2, [](const QString&) {});
    auto* last = grid->whole(QStringLiteral("Last"), QStringLiteral("last"), 1, 0, 9, [](int) {});
    inside->addWidget(grid);
    auto* below = new QLabel(QStringLiteral("below"));
    inside->addWidget(below);
    column->addWidget(card);
    column->addStretch();
    page.resize(900, 1600);
    page.show();
    const auto top = [&](const QWidget* widget) { return widget->mapTo(&page, QPoint()).y(); };
    QVERIFY2(top(last) - top(first) < 250, qPrintable(QString::number(top(last) - top(first))));
    QVERIFY2(top(below) - top(last) < 100, qPrintable(QString::number(top(below) - top(last))));
}

/// At every scale and in the longest words a name stays under its own place.
void TestStudyParts::namesOfPlacesStandApart() {
    for (const double scale : {1.0, 2.0}) {
        const desktop::Theme theme = *desktop::Theme::load(desktop::ThemeName::light, scale);
        desktop::PlacesSetup setup;
        setup.names =
            QStringList{QStringLiteral("αριστερά"), QStringLiteral("στη μέση"), QStringLiteral("δεξιά εκεί")};
        desktop::PlacesView view(theme, setup);
        desktop::PlacesView::Now now;
        now.touched = 7;
        view.resize(520, 340);
        view.show({}, now);
        std::vector<QRectF> boxes; // of the names, with their signs
        for (const tests::PaintedShape& shape : tests::PaintedShapes::of(view))
            if (shape.kind == tests::PaintedShape::Kind::words)
                boxes.push_back(shape.bounds);
        const auto covered = [&](double from, double to) {
            return std::any_of(boxes.begin(), boxes.end(),
                               [&](const QRectF& box) { return box.left() <= to && box.right() >= from; });
        };
        const double apart =
            0.04 * 340 / 0.12 * 0.9 /
            (0.9 - 0.024); // of two places where their names stand, by the view's perspective
        for (int place = -1; place <= 1; ++place)
            QVERIFY2(covered(260 + place * apart, 260 + place * apart),
                     qPrintable(QStringLiteral("at %1 nothing under place %2").arg(scale).arg(place)));
        for (const double between : {-0.5, 0.5})
            QVERIFY2(!covered(258 + between * apart, 262 + between * apart),
                     qPrintable(QStringLiteral("at %1 names touch").arg(scale)));
    }
}

/// At the limit, whatever it is, the bar is filled to its mark; without force to less.
void TestStudyParts::theForceBarMarksTheLimit() {
    for (const double limit_N : {2.0, 4.0, 6.0}) {
        desktop::PlacesView view(m_theme, desktop::PlacesSetup{});
        view.resize(520, 340);
        const auto topOfBar = [&](double force_N, double& mark) {
            desktop::PlacesView::Now now;
            now.feltNothing = true;
            now.force_N = force_N;
            now.limit_N = limit_N;
            view.show({}, now);
            mark = -1.0;
            double top = -1.0; // of what is filled: the last shape at the right before the mark
            for (const tests::PaintedShape& shape : tests::PaintedShapes::of(view)) {
                if (shape.bounds.left() < 520 - m_theme.px(45))
                    continue;
                if (shape.kind == tests::PaintedShape::Kind::line)
                    mark = shape.bounds.center().y();
                else if (shape.filled() && !shape.drawn())
                    top = shape.bounds.top();
            }
            return top;
        };
        double mark = 0.0;
        const double atLimit = topOfBar(limit_N, mark);
        QVERIFY(mark > 0.0);
        QVERIFY2(std::abs(atLimit - mark) < 1.5, qPrintable(QString::number(atLimit - mark)));
        QVERIFY(topOfBar(0.5 * limit_N, mark) > mark + 20.0); // lower on the screen
        QVERIFY(topOfBar(1.2 * limit_N, mark) < mark - 20.0);
    }
}

/// One dashed line at each tube, as far above its foot as the scene lets go; none where there is no such
/// height.
void TestStudyParts::theLineOfLettingGoStandsAtItsHeight() {
    desktop::PlacesSetup setup;
    setup.hooked = true;
    const auto lines = [&] {
        desktop::PlacesView view(m_theme, setup);
        view.resize(520, 340);
        desktop::PlacesView::Now now;
        now.objects = true;
        view.show({}, now);
        std::vector<double> heights;
        for (const tests::PaintedShape& shape : tests::PaintedShapes::of(view))
            if (shape.kind == tests::PaintedShape::Kind::line && shape.pen.style() == Qt::DashLine)
                heights.push_back(shape.bounds.center().y());
        return heights;
    };
    QVERIFY(lines().empty());
    setup.letGoHeight_m = 0.020;
    const auto low = lines();
    setup.letGoHeight_m = 0.026;
    const auto high = lines();
    QCOMPARE(low.size(), std::size_t(3));
    QCOMPARE(high.size(), std::size_t(3));
    for (std::size_t place = 0; place < 3; ++place)
        QVERIFY(high[place] < low[place] - 5.0 && low[place] == low[0]);
    setup.visible = false;
    QVERIFY(lines().empty());
}

/// The legend beside the experimenter's estimate names the procedures, so that a single one needs none.
void TestStudyParts::oneProcedureNeedsNoLegend() {
    for (const std::size_t procedures : {std::size_t{1}, std::size_t{2}}) {
        desktop::ExperimenterPanel panel(m_theme, m_locale);
        session::LiveStudyNumbers numbers;
        numbers.scored = 1;
        numbers.estimates.resize(procedures);
        for (psychophysics::ProcedureEstimate& estimate : numbers.estimates) {
            estimate.known = true;
            estimate.parameters = {{"log10_sigma", -1.2, 0.1, -1.4, -1.0}};
        }
        panel.show(session::LiveStudyView{}, numbers, psychophysics::Condition{});
        const auto* plot = panel.findChild<QCustomPlot*>();
        QVERIFY(plot && plot->legend);
        QCOMPARE(plot->legend->visible(), procedures > 1);
    }
}

/// The interval of a Weber fraction is longer upwards, and so is its bar.
void TestStudyParts::intervalsAreNoHalves() {
    report::PlotView plot(desktop::plotThemeOf(m_theme, m_locale));
    plot.setYAxis({QStringLiteral("y"), 0.0, 40.0});
    plot.setXAxis({QStringLiteral("x"), -1.0, 1.0});
    plot.setLegendShown(false);
    plot.addEstimates(QStringLiteral("estimate"), {{0.0, 10.0}}, {{5.0, 35.0}});
    tests::PaintedShapes picture(QSize(400, 400));
    QCPPainter painter(&picture);
    plot.paintTo(painter, QRectF(0.0, 0.0, 400.0, 400.0));
    painter.end();
    QRectF bar; // the longest upright line in the plot that is dark; the axis stands to the left of it
    for (const tests::PaintedShape& shape : picture.shapes())
        if (shape.kind == tests::PaintedShape::Kind::line && shape.bounds.left() > 100.0 &&
            shape.bounds.right() < 360.0 && shape.bounds.width() < 1.0 &&
            qGray(shape.pen.color().rgb()) < 128 && shape.bounds.height() > bar.height())
            bar = shape.bounds;
    // 25 of 40 up to its end, 5 down; the half of 15 would end at 25.
    QVERIFY2(bar.top() < 100.0, qPrintable(QString::number(bar.top())));
    QVERIFY2(bar.height() > 400.0 / 3.0, qPrintable(QString::number(bar.height())));
}

/// Blind, the panel beside the trials tells neither condition nor estimate nor forces; what has to do with
/// neither is told. CHIRON_KEEP_PICTURES=<folder> keeps a picture.
void TestStudyParts::experimentersAreBlindToForces() {
    psychophysics::Condition condition;
    condition.id = "craggy";
    session::LiveStudyView view;
    view.state = session::LiveStudyView::State::exploring;
    session::LiveStudyNumbers numbers;
    numbers.condition = numbers.sealedCode = "Q7M";
    numbers.blind = true;
    numbers.scored = 3;
    numbers.lastFidelity.contacts = 5;
    numbers.lastFidelity.meanSpeed_m_per_s = 0.0435;
    numbers.lastFidelity.peakForce_N = 3.21;
    numbers.lastFidelity = session::withoutForces(numbers.lastFidelity);
    numbers.lastSpoiled = "withheld";
    const auto told = [&] {
        desktop::ExperimenterPanel panel(m_theme, m_locale);
        panel.resize(360, 640);
        panel.show(view, numbers, condition);
        QString words;
        for (const QLabel* label : panel.findChildren<QLabel*>())
            words += label->text() + QLatin1Char('\n');
        if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty())
            panel.grab().save(folder + (numbers.blind ? QStringLiteral("/experimenter_blind.png")
                                                      : QStringLiteral("/experimenter_open.png")));
        return words;
    };
    const QString blind = told();
    for (const char* word : {"Q7M", "sealed", "43.5", "5 contacts", "Sealed reason"})
        QVERIFY2(blind.contains(QLatin1String(word)), qPrintable(blind));
    for (const char* word : {"craggy", "Peak force", "Felt value", "Force error", "nan"})
        QVERIFY2(!blind.contains(QLatin1String(word)), qPrintable(blind));
    numbers.blind = false;
    numbers.condition = "craggy";
    numbers.lastFidelity.peakForce_N = 3.21;
    const QString open = told();
    for (const char* word : {"craggy", "Peak force 3.21 N"})
        QVERIFY2(open.contains(QLatin1String(word)), qPrintable(open));
    condition.title = {{"en", "A rough stone"}};
    QVERIFY(told().contains(QStringLiteral("A rough stone")));
    numbers.blind = true;
    QVERIFY(!told().contains(QStringLiteral("A rough stone")));
}

void TestStudyParts::draftsAreUndone() {
    desktop::StudyDraft draft;
    draft.load(desktop::plainStudy());
    const std::string before = draft.design().title.at("en");
    QSignalSpy structure(&draft, &desktop::StudyDraft::structureChanged);
    for (const char* title : {"A", "AB", "ABC"}) // typing is one step
        draft.change(QStringLiteral("title"), QStringLiteral("title"),
                     [&](psychophysics::StudyDesign& design) { design.title["en"] = title; });
    QCOMPARE(draft.history().count(), 1);
    QCOMPARE(structure.count(), 0); // nothing was added, removed or moved
    draft.history().undo();
    QCOMPARE(draft.design().title.at("en"), before);
    draft.history().redo();
    QCOMPARE(draft.design().title.at("en"), std::string("ABC"));
    structure.clear();
    draft.change(
        QStringLiteral("procedure"), {},
        [](psychophysics::StudyDesign& design) {
            design.conditions.front().procedures.push_back(psychophysics::StaircaseSpec());
        },
        true);
    QCOMPARE(structure.count(), 1);
    QCOMPARE(draft.design().conditions.front().procedures.size(), 2U);
}

void TestStudyParts::listsAreRead() {
    const QLocale german(QLocale::German);
    QCOMPARE(desktop::readNumbers(QStringLiteral("0,5; 1 ; 2,25"), german).values,
             (std::vector<double>{0.5, 1.0, 2.25}));
    QCOMPARE(desktop::listText({0.5, 2.0}, german), QStringLiteral("0,5; 2"));
    const std::vector<double> both = desktop::differencesAround(0.2, 5);
    QCOMPARE(both[2], 0.0);
    QVERIFY(std::abs(desktop::study_words::ratioOf(both[4]) - 0.2) < 1e-12 && both[0] == -both[4]);
}

/// With each task there is one to begin with.
void TestStudyParts::plainStudyReads() {
    for (int task = 0; task < psychophysics::kTasks; ++task) {
        const psychophysics::StudyDesign plain = desktop::plainStudy(static_cast<Task>(task));
        const auto read = catalogue::readStudy(catalogue::studyJson(plain), plain.id);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QCOMPARE(static_cast<int>(read->conditions.front().task), task);
    }
}

void TestStudyParts::everyUsualProcedureReads_data() {
    QTest::addColumn<int>("task");
    for (int task = 0; task < psychophysics::kTasks; ++task)
        QTest::addRow("%s", std::string(psychophysics::token(static_cast<Task>(task))).c_str()) << task;
}

void TestStudyParts::everyUsualProcedureReads() {
    QFETCH(int, task);
    for (const std::string& kind : psychophysics::kindsFor(static_cast<Task>(task))) {
        psychophysics::StudyDesign study = desktop::plainStudy();
        psychophysics::Condition& condition = study.conditions.front();
        desktop::takeTask(condition, static_cast<Task>(task));
        condition.procedures = {psychophysics::usualProcedure(kind, condition)};
        const auto read = catalogue::readStudy(catalogue::studyJson(study), kind);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        const auto made = psychophysics::makeProcedure(read->conditions.front().procedures.front(), 1);
        QVERIFY2(made, made ? "" : made.error().message.c_str());
    }
}

void TestStudyParts::requiredItemsAreMissed() {
    const psychophysics::StudyDesign study = tests::smallStudy("one");
    desktop::QuestionnaireForm form(m_theme, m_locale, study.questionnaires.front(), QStringLiteral("en"));
    QVERIFY(form.showMissing());
    QCOMPARE(form.answered(), 0);
    form.findChild<QRadioButton*>(QStringLiteral("questionnaire.realism.4"))->click();
    form.findChild<QLineEdit*>(QStringLiteral("questionnaire.years"))
        ->setText(QStringLiteral("90")); // beyond 60
    form.findChild<QRadioButton*>(QStringLiteral("questionnaire.hand.1"))->click();
    QVERIFY(form.showMissing());
    form.findChild<QLineEdit*>(QStringLiteral("questionnaire.years"))->setText(QStringLiteral("9"));
    QVERIFY(!form.showMissing()); // remarks may be left out
    const auto answers = form.answers(5);
    QCOMPARE(answers.size(), 3U);
    QCOMPARE(answers.front().number.value_or(0.0), 4.0);
    QCOMPARE(answers.front().participant, database::ParticipantNumber(5));
}

void TestStudyParts::previewKnowsItsObserver() {
    const psychophysics::StudyDesign study = tests::smallStudy("one");
    std::vector<double> shares;
    const auto result =
        desktop::previewCondition(study, 0, {.weber = 0.1, .lapse = 0.02}, 8, [&shares](double share) {
            shares.push_back(share);
            return true;
        });
    QVERIFY(shares.size() > 2 && shares.front() == 0.0 && shares.back() <= 1.0);
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    QCOMPARE(result->plan.runs, 8);
    QVERIFY(std::abs(result->plan.biasLog10) < 0.2);
    QVERIFY(result->plan.meanTrials >= 20.0 && result->plan.meanTrials <= 40.0);
    QVERIFY(result->curve.size() >= 3 && result->plan.minutes > 1.0);
    // One run has no spread: no point of the curve, which is of both.
    const auto single =
        desktop::previewCondition(study, 0, {.weber = 0.1, .lapse = 0.02}, 1, [](double) { return true; });
    QVERIFY(single && std::isfinite(single->plan.biasLog10) && !std::isfinite(single->plan.sdLog10));
    QVERIFY(single->curve.empty());
    const auto stopped = desktop::previewCondition(study, 0, {}, 8, [](double) { return false; });
    QVERIFY(!stopped && stopped.error().code == core::ErrorCode::cancelled);
}

void TestStudyParts::numbersWithUnits() {
    using namespace desktop::study_words;
    QCOMPARE(value(0.1, psychophysics::Attribute::mass, m_locale), QStringLiteral("100 g"));
    QCOMPARE(value(312.4, psychophysics::Attribute::stiffness, m_locale), QStringLiteral("312 N/m"));
    QCOMPARE(percent(0.1234, m_locale), QStringLiteral("12.3 %"));
    QCOMPARE(percent(std::nan(""), m_locale), QStringLiteral("–"));
    QCOMPARE(plainNumber(4.0, m_locale), QStringLiteral("4"));
    QCOMPARE(plainNumber(3.5, m_locale), QStringLiteral("3.5"));
    QCOMPARE(session_report::warningWords({psychophysics::WarningKind::noMarks}),
             QStringLiteral("There is no mark to summarise."));
}

/// As many digits as tell neighbours apart, and no more than usual where three do.
void TestStudyParts::neighboursReadDifferently() {
    using namespace desktop::study_words;
    const auto stiffness = psychophysics::Attribute::stiffness;
    QCOMPARE(
        values({153.06, 153.31, 153.57}, stiffness, m_locale),
        (QStringList{QStringLiteral("153.1 N/m"), QStringLiteral("153.3 N/m"), QStringLiteral("153.6 N/m")}));
    QCOMPARE(values({300.0, 306.0, 480.0}, stiffness, m_locale),
             (QStringList{QStringLiteral("300 N/m"), QStringLiteral("306 N/m"), QStringLiteral("480 N/m")}));
    // What is the same need not differ, also if it was computed in two ways.
    QCOMPARE(values({300.0, 300.0, 3.0 * (100.0 + 1e-12)}, stiffness, m_locale).join(QLatin1Char('|')),
             QStringLiteral("300 N/m|300 N/m|300 N/m"));
    QCOMPARE(percents({0.0200, 0.0204}, m_locale),
             (QStringList{QStringLiteral("2.00 %"), QStringLiteral("2.04 %")}));
    QCOMPARE(interval(0.081, 0.12, m_locale), QStringLiteral("0.0810 … 0.120"));
    QCOMPARE(interval(0.12341, 0.12344, m_locale), QStringLiteral("0.12341 … 0.12344"));
    QCOMPARE(intervalPercent(0.12341, 0.12344, m_locale), QStringLiteral("12.341 … 12.344 %"));
    QVERIFY(intervalPercent(0.1, std::nan(""), m_locale).isEmpty());
}

void TestStudyParts::aTableOfLevelsTellsItsObjectsApart() {
    psychophysics::StimulusDesign stimulus;
    stimulus.reference = 150.0;
    std::vector<double> percents;
    for (const double difference : desktop::differencesBetween(0.02, 0.6, 40))
        percents.push_back(100.0 * desktop::study_words::ratioOf(difference));
    percents.push_back(percents.back() + 1e-3);
    desktop::LevelsTable levels(
        m_theme, m_locale, false, QStringLiteral("levels"), percents,
        [&](const std::vector<double>& of) { return desktop::objectsOf(stimulus, of, m_locale); });
    auto* table = levels.findChild<QTableWidget*>(QStringLiteral("levels.table"));
    QVERIFY(table && table->rowCount() == 41);
    QVERIFY(table->accessibleName().contains(QStringLiteral("per cent")));
    for (int row = 1; row < table->rowCount(); ++row)
        for (int column : {0, 1})
            QVERIFY2(table->item(row, column)->text() != table->item(row - 1, column)->text(),
                     qPrintable(table->item(row, column)->text()));
    // A row that is emptied is told, and nothing is taken from the others.
    QSignalSpy unread(&levels, &desktop::LevelsTable::unread);
    QSignalSpy changed(&levels, &desktop::LevelsTable::changed);
    table->item(3, 0)->setText({});
    QCOMPARE(changed.count(), 0);
    QVERIFY(!unread.isEmpty() && unread.last().front().toString().contains(QStringLiteral("empty")));
    table->item(3, 0)->setText(QStringLiteral("2.4"));
    QCOMPARE(changed.count(), 1);
    const auto now = changed.last().front().value<std::vector<double>>();
    QVERIFY(now.size() == 41 && now[3] == 2.4 && now[0] == percents[0]); // the others unrounded
}

void TestStudyParts::shortNamesAreMadeOfTitles() {
    using desktop::isMadeOf;
    QCOMPARE(desktop::shortNameOf(QStringLiteral("60 Tübes, of 1.5 N/m!")),
             QStringLiteral("tubes_of_1_5_n_m"));
    QVERIFY(desktop::shortNameOf(QStringLiteral("Σωλήνας")).isEmpty());
    QCOMPARE(
        desktop::freeShortName(QStringLiteral("tube"), {QStringLiteral("tube"), QStringLiteral("tube_2")}),
        QStringLiteral("tube_3"));
    const QString title = QStringLiteral("Tube of 60 N/m");
    for (const char* name : {"tube_of_60_n_m", "tube_of_60_n_m_2", "tube_of_60_n_m_12"})
        QVERIFY2(isMadeOf(QLatin1String(name), title), name);
    for (const char* name : {"soft", "tube", "tube_60", "tube_60_2", "tube_of_60_n_m_soft", ""}) // chosen
        QVERIFY2(!isMadeOf(QLatin1String(name), title), name);
    QVERIFY(!isMadeOf(QString(), QStringLiteral("Σωλήνας")));
}

/// What a new study begins with is what the templates have; a line is still told to be short.
/// Of the program's own names; what somebody typed, and what nobody could have made, stays.
void TestStudyParts::namesFollowTheAttribute() {
    using psychophysics::Attribute;
    std::set<std::string> typed;
    const auto changed = [&typed](psychophysics::StudyDesign design, std::size_t at, Attribute attribute) {
        const psychophysics::StimulusDesign before = design.conditions[at].stimulus;
        desktop::takeAttribute(design.conditions[at], attribute);
        desktop::nameByAttribute(design, at, before.attribute, before.reference,
                                 [&typed](const std::string& name) { return typed.contains(name); });
        return design;
    };
    psychophysics::StudyDesign design = desktop::plainStudy();
    const auto named = [](const psychophysics::Condition& condition) {
        return condition.title.at("en") + " | " + condition.id;
    };
    QCOMPARE(named(changed(design, 0, Attribute::mass).conditions[0]), std::string("Mass | mass"));
    QCOMPARE(changed(design, 0, Attribute::mass).title, design.title); // it tells no attribute
    typed = {"Stiffness"};
    QCOMPARE(named(changed(design, 0, Attribute::mass).conditions[0]), std::string("Stiffness | stiffness"));
    typed.clear();
    design.conditions[0].title = {{"en", "Soft and wet"}};
    QCOMPARE(changed(design, 0, Attribute::mass).conditions[0].title, design.conditions[0].title);

    const auto templates = catalogue::StudyCatalogue::load();
    QVERIFY(templates && templates->find("stiffness_2afc_two_tubes"));
    design = *templates->find("stiffness_2afc_two_tubes");
    psychophysics::StudyDesign after = changed(design, 0, Attribute::mass);
    QCOMPARE(named(after.conditions[0]), std::string("Mass of 100 g | mass_of_100_g"));
    QCOMPARE(after.conditions[0].title.size(), std::size_t{1}); // no German tube of some mass
    QCOMPARE(after.conditions[1].title, design.conditions[1].title);
    QCOMPARE(after.title, design.title); // the other condition is still about stiffness
    after = changed(after, 1, Attribute::mass);
    QCOMPARE(named(after.conditions[1]), std::string("Mass of 100 g (2) | mass_of_100_g_2"));
    QCOMPARE(after.title.at("en"), std::string("Mass, two alternatives"));
    typed = {design.title.at("en"), design.conditions[0].id};
    after = changed(changed(design, 0, Attribute::mass), 1, Attribute::mass);
    QCOMPARE(after.title, design.title);
    QCOMPARE(named(after.conditions[0]), std::string("Mass of 100 g | tube_60"));
}

void TestStudyParts::theUsualConsentIsNotShort() {
    psychophysics::StudyDesign design = desktop::plainStudy();
    const auto templates = catalogue::StudyCatalogue::load();
    QVERIFY(templates && !templates->studies().empty());
    for (const psychophysics::StudyDesign& each : templates->studies())
        QCOMPARE(each.consent.at("en"), design.consent.at("en"));
    const auto state = [&] {
        for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, {}, m_locale))
            if (each.name == QStringLiteral("consent"))
                return each.state;
        return desktop::FreezeCheck::State::waiting;
    };
    QVERIFY(state() == desktop::FreezeCheck::State::good);
    design.consent["en"] = "I take part of my own free will and may stop at any time.";
    QVERIFY(state() == desktop::FreezeCheck::State::advice);
}

void TestStudyParts::rangesOfProceduresAreThoseThatAreTaken_data() {
    everyUsualProcedureReads_data();
}

/// The range that stands below a number is the one that the field takes, and a number beyond it is told.
void TestStudyParts::rangesOfProceduresAreThoseThatAreTaken() {
    QFETCH(int, task);
    const auto plain = [](QString text) { return text.remove(QLatin1Char(',')); };
    for (const std::string& kind : psychophysics::kindsFor(static_cast<Task>(task))) {
        psychophysics::StudyDesign study = desktop::plainStudy(static_cast<Task>(task));
        psychophysics::Condition& condition = study.conditions.front();
        condition.procedures = {psychophysics::usualProcedure(kind, condition)};
        desktop::StudyDraft draft;
        draft.load(study);
        desktop::ProcedureForm form(m_theme, m_locale, false, draft, {});
        form.show();
        QVERIFY(QTest::qWaitForWindowExposed(&form));
        for (QSpinBox* field : form.findChildren<QSpinBox*>()) {
            const QString name = field->objectName();
            const auto* meaning = form.findChild<QLabel*>(name + QStringLiteral(".meaning"));
            QVERIFY2(meaning, qPrintable(name));
            const QString range = QStringLiteral("%1 to %2").arg(field->minimum()).arg(field->maximum());
            QVERIFY2(plain(meaning->text()).contains(range), qPrintable(name + QStringLiteral(": ") + range));
            const int before = field->value();
            const int most = field->maximum();
            field->selectAll();
            QTest::keyClicks(field, QString::number(most + 1LL));
            QTest::keyClick(field, Qt::Key_Return);
            QCOMPARE(field->value(), before);
            QVERIFY2(plain(form.faultOf(name)).contains(QString::number(most)),
                     qPrintable(form.faultOf(name)));
        }
    }
}

// A low field beside a high button, and below them what did not fit any more.
void TestStudyParts::controlsOfALineAreLevel() {
    QWidget page;
    auto* flow = new desktop::FlowLayout(10, &page);
    QWidget* controls[] = {new QWidget, new QWidget, new QWidget};
    const QSize sizes[] = {{100, 20}, {100, 40}, {150, 30}};
    for (int i = 0; i < 3; ++i) {
        controls[i]->setFixedSize(sizes[i]);
        flow->addWidget(controls[i]);
    }
    QCOMPARE(flow->heightForWidth(220), 40 + 10 + 30);
    page.resize(220, 200);
    page.show();
    QCOMPARE(controls[0]->geometry(), QRect(0, 10, 100, 20));
    QCOMPARE(controls[1]->geometry(), QRect(110, 0, 100, 40));
    QCOMPARE(controls[2]->geometry(), QRect(0, 50, 150, 30));
}

void TestStudyParts::quantitiesAreReadWithTheirUnits() {
    using Fault = desktop::ReadQuantity::Fault;
    const QLocale german(QLocale::German);
    struct Case {
        const char* typed;
        const char* unit;
        Fault fault;
        double value;
    };
    for (const Case& each : {Case{"0.3 N/mm", "N/m", Fault::none, 300.0},
                             Case{"0.3N/mm", "N/m", Fault::none, 300.0},
                             Case{"300", "N/m", Fault::none, 300.0},
                             Case{"300 N/m", "N/m", Fault::none, 300.0},
                             Case{"2 kN/m", "N/m", Fault::none, 2000.0},
                             Case{"20 mm", "m", Fault::none, 0.02},
                             Case{"1500 ms", "s", Fault::none, 1.5},
                             Case{"2 min", "s", Fault::none, 120.0},
                             Case{"0.05 kg", "g", Fault::none, 50.0},
                             Case{"0.1 mm", "\u00B5m", Fault::none, 100.0},
                             Case{"100 \u03BCm", "\u00B5m", Fault::none, 100.0},
                             Case{"300 mN", "N", Fault::none, 0.3},
                             Case{"200 mm/s", "m/s", Fault::none, 0.2},
                             Case{"4 Ns/m", "N\u00B7s/m", Fault::none, 4.0},
                             Case{"4 N\u22C5s/m", "N\u00B7s/m", Fault::none, 4.0},
                             Case{"4 N*s/m", "N\u00B7s/m", Fault::none, 4.0},
                             Case{"4 N\u00B7s/mm", "N\u00B7s/m", Fault::none, 4000.0},
                             Case{"30 %", "", Fault::none, 0.3},
                             Case{"5 %", "%", Fault::none, 5.0},
                             Case{"0.3 kg", "N/m", Fault::otherUnit, 0.0},
                             Case{"0.3 N", "N/m", Fault::otherUnit, 0.0},
                             Case{"0.3 N/mmm", "N/m", Fault::otherUnit, 0.0},
                             Case{"3 N", "", Fault::otherUnit, 0.0},
                             Case{"abc", "N/m", Fault::noNumber, 0.0},
                             Case{"", "N/m", Fault::empty, 0.0}}) {
        const desktop::ReadQuantity read =
            desktop::readQuantity(QString::fromUtf8(each.typed), QString::fromUtf8(each.unit), m_locale);
        QVERIFY2(read.fault == each.fault, each.typed);
        QVERIFY2(each.fault != Fault::none ||
                     std::abs(read.value - each.value) < 1e-9 * std::max(1.0, each.value),
                 each.typed);
    }
    QCOMPARE(desktop::readQuantity(QStringLiteral("0,3 N/mm"), QStringLiteral("N/m"), german).value, 300.0);
    QCOMPARE(desktop::readQuantity(QStringLiteral("0.3 N/mm"), QStringLiteral("N/m"), german).value, 300.0);
    QVERIFY(desktop::readQuantity(QStringLiteral("0,3"), QStringLiteral("N/m"), m_locale).fault ==
            Fault::noNumber); // 0.3, or 0 and 3
}

/// A unit of the same dimension is converted and shown; anything else is told at the field, which keeps what
/// it had.
void TestStudyParts::anEmptiedFieldIsNoZero() {
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    auto* grid = new desktop::FieldGrid(m_theme, m_locale, false);
    double reference = 60.0, limit = 8.0;
    auto* plain = grid->number(QStringLiteral("Reference"), QStringLiteral("reference"), reference,
                               {0, 1e9, 4, QStringLiteral("N/m"), 1}, [&](double now) { reference = now; });
    auto* special = grid->number(QStringLiteral("Limit"), QStringLiteral("limit"), limit,
                                 {0, 100, 1, QStringLiteral("s"), 1, QStringLiteral("no limit")},
                                 [&](double now) { limit = now; });
    column->addWidget(grid);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    for (QDoubleSpinBox* field : {plain, special}) {
        field->setFocus();
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClick(field, Qt::Key_Return);
    }
    QCOMPARE(reference, 60.0);
    QCOMPARE(limit, 8.0);
    QCOMPARE(plain->text(), QStringLiteral("60 N/m"));
    special->setFocus();
    special->selectAll();
    QTest::keyClicks(special, QStringLiteral("no limit"));
    QTest::keyClick(special, Qt::Key_Return);
    QCOMPARE(limit, 0.0);
    QCOMPARE(special->text(), QStringLiteral("no limit"));
    QVERIFY(grid->faultOf(QStringLiteral("limit")).isEmpty());
}

void TestStudyParts::whatIsTypedIsTakenOrTold() {
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    auto* grid = new desktop::FieldGrid(m_theme, m_locale, false);
    double taken = 60.0;
    int trials = 20;
    auto* field = grid->number(QStringLiteral("Reference"), QStringLiteral("reference"), taken,
                               {0, 1e9, 4, QStringLiteral("N/m"), 1}, [&](double now) { taken = now; });
    auto* whole = grid->whole(QStringLiteral("Trials"), QStringLiteral("trials"), trials, 0, 100,
                              [&](int now) { trials = now; });
    column->addWidget(grid);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    const auto typeInto = [](QAbstractSpinBox* into, const QString& words) {
        into->setFocus();
        into->selectAll();
        QTest::keyClicks(into, words);
        QTest::keyClick(into, Qt::Key_Return);
    };
    typeInto(field, QStringLiteral("0.3 N/mm"));
    QCOMPARE(taken, 300.0);
    QCOMPARE(field->text(), QStringLiteral("300 N/m"));
    QVERIFY(grid->faultOf(QStringLiteral("reference")).isEmpty());
    for (const char* wrong : {"0.5 kg", "soft", "0.5 N"}) {
        typeInto(field, QLatin1String(wrong));
        QCOMPARE(taken, 300.0); // also where a beginning of it is a number
        QCOMPARE(field->text(), QStringLiteral("300 N/m"));
        const QString told = grid->faultOf(QStringLiteral("reference"));
        QVERIFY2(told.contains(QLatin1String(wrong)) && told.contains(QStringLiteral("N/m")),
                 qPrintable(told));
        QCOMPARE(grid->firstUnread(), QStringLiteral("reference"));
    }
    typeInto(field, QStringLiteral("2000000000")); // more than it takes
    QVERIFY2(grid->faultOf(QStringLiteral("reference")).contains(QStringLiteral("from 0")),
             qPrintable(grid->faultOf(QStringLiteral("reference"))));
    QCOMPARE(taken, 300.0);
    const auto* fault = grid->findChild<QWidget*>(QStringLiteral("reference.fault"));
    QVERIFY(fault);
    QTRY_VERIFY_WITH_TIMEOUT(fault->mapTo(&page, QPoint()).y() > field->mapTo(&page, QPoint()).y(),
                             tests::kPatience_ms); // below its field
    auto* large = grid->number(QStringLiteral("Large"), QStringLiteral("large"), 1.0, {0, 1.5e6, 0, {}, 1},
                               [](double) {});
    typeInto(large, QStringLiteral("2000000"));
    QVERIFY2(grid->faultOf(QStringLiteral("large")).contains(QStringLiteral("1,500,000")), // as people write
             qPrintable(grid->faultOf(QStringLiteral("large"))));
    typeInto(large, QStringLiteral("2"));
    typeInto(field, QStringLiteral("120"));
    QCOMPARE(taken, 120.0);
    QVERIFY(grid->faultOf(QStringLiteral("reference")).isEmpty() && grid->firstUnread().isEmpty());
    typeInto(whole, QStringLiteral("2.5")); // neither 2 nor 25
    QCOMPARE(trials, 20);
    QVERIFY(grid->faultOf(QStringLiteral("trials")).contains(QStringLiteral("2.5")));
    typeInto(whole, QStringLiteral("15"));
    QCOMPARE(trials, 15);
    QVERIFY(grid->firstUnread().isEmpty());
    typeInto(whole, QStringLiteral("101")); // not 10 either, which is how it begins
    QCOMPARE(trials, 15);
    QVERIFY2(grid->faultOf(QStringLiteral("trials")).contains(QStringLiteral("from 0 to 100")),
             qPrintable(grid->faultOf(QStringLiteral("trials"))));
    typeInto(whole, QStringLiteral("16"));
    // An emptied field does not get its number back without a word.
    for (QAbstractSpinBox* emptied :
         {static_cast<QAbstractSpinBox*>(field), static_cast<QAbstractSpinBox*>(whole)}) {
        emptied->setFocus();
        emptied->selectAll();
        QTest::keyClick(emptied, Qt::Key_Delete);
        QTest::keyClick(emptied, Qt::Key_Return);
        QVERIFY2(grid->faultOf(emptied->objectName()).contains(QStringLiteral("The value is still")),
                 qPrintable(grid->faultOf(emptied->objectName())));
    }
    QCOMPARE(taken, 120.0);
    QCOMPARE(trials, 16);
    // Each number of a list has its range, too.
    std::vector<double> shares{2.0};
    auto* list = grid->list(QStringLiteral("Shares"), QStringLiteral("shares"), shares,
                            [&](std::vector<double> now) { shares = std::move(now); },
                            {0, 100, 1, QStringLiteral("%")});
    list->selectAll();
    QTest::keyClicks(list, QStringLiteral("5; 120"));
    QVERIFY2(grid->faultOf(QStringLiteral("shares")).contains(QStringLiteral("from 0 to 100 %")),
             qPrintable(grid->faultOf(QStringLiteral("shares"))));
    QCOMPARE(shares, (std::vector<double>{5.0, 12.0})); // as far as it was read
    QTest::keyClick(list, Qt::Key_Backspace);
    QVERIFY(grid->faultOf(QStringLiteral("shares")).isEmpty());
    QCOMPARE(shares, (std::vector<double>{5.0, 12.0}));
}

/// Before anything is frozen: masking that nobody would hear, or that is off, and objects that count from a
/// graze on.
void TestStudyParts::soundAndForceAreCheckedBeforeFreezing() {
    using State = desktop::FreezeCheck::State;
    psychophysics::StudyDesign design = desktop::plainStudy();
    const auto stateOf = [&](const char* name, const desktop::FreezeFacts& facts) -> std::optional<State> {
        for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, facts, m_locale))
            if (each.name == QLatin1String(name))
                return each.state;
        return std::nullopt;
    };
    desktop::FreezeFacts facts;
    QVERIFY(!stateOf("masking", facts)); // nobody has looked
    facts.hasSound = false;
    QVERIFY(stateOf("masking", facts) == State::advice);
    facts.hasSound = true;
    QVERIFY(stateOf("masking", facts) == State::good);
    design.trial.maskingSound = false;
    QVERIFY(stateOf("masking", facts) == State::advice);
    QVERIFY(stateOf("probe", facts) == State::good); // new studies have one
    design.trial.probeAtLeast_N = 0.0;
    QVERIFY(stateOf("probe", facts) == State::advice);
    design.trial.mustTouchAll = false;
    QVERIFY(!stateOf("probe", facts));
    QVERIFY(!stateOf("force", facts)); // nobody has looked at the device
    facts.rendersForce = true;
    QVERIFY(stateOf("force", facts) == State::good);
    facts.rendersForce = false;
    QVERIFY(stateOf("force", facts) == State::advice);
    for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, facts, m_locale))
        if (each.name == u"force")
            QVERIFY2(each.words.contains(QStringLiteral("left out of groups and comparisons")) &&
                         each.tab < 0,
                     qPrintable(each.words));
}

/// A duration is an expectation, and tells what it rests on; a ratio is one of Weber fractions; and what is
/// lifted need not be pressed.
void TestStudyParts::whatIsToldBeforeFreezingSaysOfWhat() {
    psychophysics::StudyDesign design = tests::smallStudy("says_of_what");
    desktop::FreezeFacts facts;
    const auto words = [&](const char* name) {
        for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, facts, m_locale))
            if (each.name == QLatin1String(name))
                return each.words;
        return QString();
    };
    const QString duration = desktop::durationWords(design, m_locale);
    QVERIFY2(duration.startsWith(QStringLiteral("about ")) &&
                 duration.contains(QStringLiteral("if each takes")) &&
                 !duration.contains(QStringLiteral("at most")),
             qPrintable(duration));
    QVERIFY2(words("duration").contains(duration), qPrintable(words("duration")));
    facts.plans.emplace(design.conditions.size());
    for (psychophysics::ConditionPlan& plan : *facts.plans)
        plan.sdLog10 = plan.sdError = 0.02;
    design.participantsPlanned = 12;
    QVERIFY2(words("precision").contains(QStringLiteral("With 12 participants")) &&
                 words("precision").contains(QStringLiteral("Weber fraction of one is at least")) &&
                 words("precision").contains(QStringLiteral("80 % power")),
             qPrintable(words("precision")));
    design.trial.mustTouchAll = true;
    design.trial.probeAtLeast_N = 0.3;
    QVERIFY(words("probe").contains(QStringLiteral("0.3 N")));
    for (psychophysics::Condition& condition : design.conditions)
        condition.stimulus.attribute = psychophysics::Attribute::mass;
    QVERIFY2(words("probe").contains(QStringLiteral("lifted")) && !words("probe").contains(u'N'),
             qPrintable(words("probe")));
}

/// Whoever merely holds it would be told that they pull too hard.
void TestStudyParts::aHeavyObjectIsAdvisedAgainst() {
    psychophysics::StudyDesign design = tests::smallStudy("heavy"); // at most 2.96 N, of 4 N
    QVERIFY(!desktop::weightCheck(design, m_locale));
    design.conditions[0].stimulus.reference = 19000.0; // a stiffness has no weight
    QVERIFY(!desktop::weightCheck(design, m_locale));
    design.conditions[1].stimulus.reference = 0.3; // 2.94 N, times 3.02 as the heaviest of three
    const auto check = desktop::weightCheck(design, m_locale);
    QVERIFY(check && check->state == desktop::FreezeCheck::State::advice);
    QCOMPARE(check->field, QStringLiteral("fidelity.peak_force"));
    const auto all = desktop::freezeChecks(design, {}, m_locale);
    QVERIFY(std::any_of(all.begin(), all.end(), [](const auto& each) { return each.name == u"weight"; }));
    for (const char* force : {"8.88 N", "3.20 N", "11.11 N"})
        QVERIFY2(check->words.contains(QLatin1String(force)), qPrintable(check->words));
    design.fidelity.peakForce_N = 11.10;
    QVERIFY(desktop::weightCheck(design, m_locale));
    design.fidelity.peakForce_N = 11.11; // as advised
    QVERIFY(!desktop::weightCheck(design, m_locale));
    design.fidelity.peakForce_N = 4.0;
    design.conditions[1].task = psychophysics::Task::twoAfc; // 5.11 N
    QVERIFY2(desktop::weightCheck(design, m_locale)->words.contains(QStringLiteral("5.11 N")),
             qPrintable(desktop::weightCheck(design, m_locale)->words));
}

/// Runs that give no value at all are told before freezing, of the condition that has the most.
void TestStudyParts::runsWithoutValuesAreToldBeforeFreezing() {
    using State = desktop::FreezeCheck::State;
    const psychophysics::StudyDesign design = desktop::plainStudy();
    desktop::FreezeFacts facts;
    const auto values = [&]() -> std::optional<desktop::FreezeCheck> {
        for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, facts, m_locale))
            if (each.name == u"values")
                return each;
        return std::nullopt;
    };
    QVERIFY(values() && values()->state == State::waiting);
    facts.plans.emplace(std::size_t{2}); // nothing that could be simulated
    QVERIFY(!values());
    for (psychophysics::ConditionPlan& plan : *facts.plans)
        plan.runs = 40;
    QVERIFY(!values()); // marks of an apex: nothing is counted
    for (psychophysics::ConditionPlan& plan : *facts.plans)
        plan.withoutValue = 0;
    QVERIFY(values() && values()->state == State::good);
    facts.plans->back().withoutValue = 1;
    QVERIFY(values()->state == State::good && values()->words.contains(QStringLiteral("1 of 40")));
    facts.plans->back().withoutValue = 18;
    QVERIFY(values()->state == State::advice && values()->words.contains(QStringLiteral("18 of 40")));
    QVERIFY(!values()->words.contains(QStringLiteral("With about")));
    facts.plans->back().trialsForValues = 30;
    QVERIFY2(values()->words.contains(QStringLiteral("With about 30 trials or more")),
             qPrintable(values()->words));
}

void TestStudyParts::anEarlierExportIsReplacedOrKept() {
    const QTemporaryDir place;
    const QString folder = place.filePath(QStringLiteral("tables"));
    const auto writes = [&](const char* words) {
        return [folder, words]() -> core::Result<void> {
            QFile file(folder + QStringLiteral("/data"));
            return QDir().mkpath(folder) && file.open(QIODevice::WriteOnly) && file.write(words) > 0
                       ? core::Result<void>()
                       : core::fail(core::ErrorCode::storage, "not written");
        };
    };
    const auto content = [](const QString& in) {
        QFile file(in + QStringLiteral("/data"));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    };
    const auto folders = [&] { return QDir(place.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot); };
    QVERIFY(desktop::inPlaceOf(folder, false, writes("first")));
    QVERIFY(desktop::inPlaceOf(folder, true, writes("second")));
    QCOMPARE(content(folder), QStringLiteral("second"));
    QCOMPARE(folders(), QStringList{QStringLiteral("tables")});
    const auto failed = desktop::inPlaceOf(folder, true, [] {
        return core::Result<void>(core::fail(core::ErrorCode::storage, "the disk is full"));
    });
    QVERIFY(!failed && failed.error().message == "the disk is full");
    QCOMPARE(content(folder), QStringLiteral("second")); // the earlier one is back
    QCOMPARE(folders(), QStringList{QStringLiteral("tables")});
    const auto half = desktop::inPlaceOf(folder, true, [&]() -> core::Result<void> {
        (void)writes("half")();
        return core::fail(core::ErrorCode::storage, "the disk is full");
    });
    QVERIFY(!half && half.error().message.find("the disk is full; the earlier export is now ") == 0 &&
            half.error().message.find("tables-before") != std::string::npos);
    QCOMPARE(content(place.filePath(QStringLiteral("tables-before"))),
             QStringLiteral("second")); // nothing is lost
    QCOMPARE(desktop::freeFolder(folder), folder + QStringLiteral("-2"));
    QCOMPARE(desktop::freeFolder(place.filePath(QStringLiteral("none"))),
             place.filePath(QStringLiteral("none")));
    const auto missing = desktop::inPlaceOf(place.filePath(QStringLiteral("none")), true, writes("never"));
    QVERIFY(!missing && missing.error().message.find("cannot be moved away") != std::string::npos);
}

QTEST_MAIN(TestStudyParts)
#include "test_study_parts.moc"
