// SPDX-License-Identifier: GPL-3.0-or-later
// What the desktop paints by hand: bars, dials, plots that scroll, charts, pictures of exercises. As it was
// looked at (support/kept_pictures.h), and as lines of what is painted (support/paint_outline.h). Kept anew,
// and the difference read: CHIRON_STORE_PICTURES=1 CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen
// build/release/tests/gui/training/test_kept_widgets
#include "app/exercises/palpation/desktop/lean_dial.h"
#include "app/exercises/palpation/desktop/palpation_map_view.h"
#include "app/exercises/palpation/desktop/size_row.h"
#include "catalogue/catalogue.h"
#include "desktop/debrief/band_bar.h"
#include "desktop/debrief/meaning_table.h"
#include "desktop/home/exercise_picture.h"
#include "desktop/people/people_model.h"
#include "desktop/people/role_chips.h"
#include "desktop/playback/scrubber.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/sessions/plain_cell_delegate.h"
#include "desktop/station/lateness_chart.h"
#include "desktop/study_run/places_view.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/mouse_pictogram.h"
#include "desktop/training/signed_bar.h"
#include "desktop/training/sound_sign.h"
#include "desktop/training/target_bar.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "session/playback_track.h"
#include "support/kept_pictures.h"
#include "support/kept_text.h"
#include "support/paint_outline.h"
#include "support/patience.h"

#include <QStandardItemModel>
#include <QTableView>
#include <QtTest>
#include <cmath>
#include <functional>
#include <tuple>

using namespace chiron;
using namespace chiron::desktop;

namespace {

using Made = std::unique_ptr<QWidget>;

/// Cells of a table by a delegate of its own: plain, with a sign, in a colour, too long, selected.
Made cells(const Theme& theme, bool chips) {
    auto view = std::make_unique<QTableView>();
    auto* model = new QStandardItemModel(2, 3, view.get());
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) {
            auto* item = new QStandardItem(column == 2 ? QStringLiteral("far too long for the room of a cell")
                                                       : QStringLiteral("cell %1").arg(column));
            if (chips)
                item->setData(column == 0
                                  ? QStringList{QStringLiteral("Trainer")}
                                  : QStringList{QStringLiteral("Trainee"), QStringLiteral("Researcher")},
                              PeopleModel::kChips);
            else if (column == 1) {
                item->setData(static_cast<int>(Qt::AlignRight | Qt::AlignVCenter), Qt::TextAlignmentRole);
                item->setData(theme.color(Colour::bad), Qt::ForegroundRole);
            } else if (row == 0 && column == 0)
                item->setData(theme.icon("object-unlocked"), Qt::DecorationRole);
            else if (row == 1 && column == 2)
                item->setData(QStringLiteral("a second line"), PlainCellDelegate::kSecondLine);
            model->setItem(row, column, item);
        }
    view->setModel(model);
    view->setItemDelegate(chips ? static_cast<QAbstractItemDelegate*>(new RoleChips(theme, view.get()))
                                : new PlainCellDelegate(theme, view.get()));
    view->selectionModel()->select(model->index(1, 0),
                                   QItemSelectionModel::Select | QItemSelectionModel::Rows);
    return view;
}

/// Rows with what they mean below their names, short and long, and one of which nothing more is said.
Made meanings(const Theme& theme) {
    auto table = std::make_unique<MeaningTable>(theme, 3);
    table->setHorizontalHeaderLabels(
        {QStringLiteral("Metric"), QStringLiteral("Value"), QStringLiteral("Nothing")});
    table->setRowCount(3);
    const char* const words[] = {
        "How long it took, from the first movement to the mark.",
        "How far the mark lies from the true top, measured across, as a share of the "
        "radius, whether the ball was seen or not.",
        ""};
    for (int row = 0; row < 3; ++row) {
        auto* name = new QTableWidgetItem(QStringLiteral("Metric %1").arg(row + 1));
        name->setData(Qt::AccessibleDescriptionRole, QLatin1String(words[row]));
        table->setItem(row, 0, name);
        table->setItem(row, 1, new QTableWidgetItem(QString::number(1.5 * row)));
    }
    table->hideEmptyColumns();
    table->selectRow(1);
    return table;
}

Made palpationMap(const Theme& theme, const QLocale& locale) {
    simulation::SurfaceMap map({0.04, 0.03}, 0.0045, 0.5);
    for (int i = 0; i < 30; ++i)
        map.press({-0.03 + 0.002 * i, 0.01 * std::sin(0.4 * i)}, 0.25 * i);
    report::PalpationMapView view;
    view.kind = simulation::SurfaceMapKind::force;
    view.lumps = {{0.010, 0.005, 0.006, 0.005, 3, true}, {-0.020, -0.015, 0.004, 0.004, 5, false}};
    view.findings = {{1, 0.012, 0.004, 0.006, simulation::FindingOutcome::hit, true},
                     {2, 0.030, -0.020, 0.0, simulation::FindingOutcome::falseAlarm, false},
                     {3, -0.030, 0.020, 0.005, simulation::FindingOutcome::open, false}};
    auto widget = std::make_unique<PalpationMapView>(plotThemeOf(theme, locale));
    widget->setMinimumSize(theme.px(560), theme.px(380));
    widget->show(map, view);
    return widget;
}

std::map<QString, Made> widgets(const Theme& theme, const QLocale& locale,
                                const catalogue::Catalogue& catalogue) {
    std::map<QString, Made> all;
    // ---- bars ----
    for (const auto& [name, value] : {std::pair{"low", 0.7}, {"near", 3.9}, {"over", 5.2}, {"none", 0.0}}) {
        auto bar = std::make_unique<ForceBar>(
            theme, locale, ForceBar::Quantity{QStringLiteral("Force"), QStringLiteral("N"), 4.0, 2}, true);
        bar->setValue(value);
        all[QStringLiteral("force_bar_%1").arg(QLatin1String(name))] = std::move(bar);
    }
    auto silent = std::make_unique<ForceBar>(
        theme, locale, ForceBar::Quantity{QStringLiteral("Force"), QStringLiteral("N"), 4.0, 2}, false);
    silent->setValue(2.0);
    all[QStringLiteral("force_bar_no_number")] = std::move(silent);
    for (const auto& [name, value] : {std::pair{"below", 0.6}, {"in", 1.2}, {"above", 1.9}, {"over", 2.8}}) {
        auto bar = std::make_unique<TargetBar>(
            theme, locale, TargetBar::Quantity{QStringLiteral("Tension"), QStringLiteral("N"), 3.0, 2}, true);
        bar->setBand(1.05, 1.35);
        bar->setLimit(2.5);
        bar->setValue(value);
        all[QStringLiteral("target_bar_%1").arg(QLatin1String(name))] = std::move(bar);
    }
    for (const auto& [name, value] : {std::pair{"left", -1.4}, {"right", 0.8}, {"over", -2.6}}) {
        auto bar = std::make_unique<SignedBar>(theme, locale,
                                               SignedBar::Quantity{QStringLiteral("Fx"),
                                                                   QStringLiteral("Force along x"),
                                                                   QStringLiteral("N"), 2.0, 2},
                                               true, true);
        bar->setValue(value);
        all[QStringLiteral("signed_bar_%1").arg(QLatin1String(name))] = std::move(bar);
    }
    // ---- of a finger ----
    auto one = std::make_unique<LeanDial>(theme, locale, 1);
    one->setLean(0, 0.2, -0.15, false);
    all[QStringLiteral("lean_dial_one")] = std::move(one);
    auto two = std::make_unique<LeanDial>(theme, locale, 2);
    two->setLean(0, -0.3, 0.1, false);
    two->setLean(1, 0.1, 0.5, true);
    all[QStringLiteral("lean_dial_two")] = std::move(two);
    for (const double radius_m : {0.0, 0.003, 0.015}) {
        auto row = std::make_unique<SizeRow>(theme, locale, 0.0075);
        row->setRadius(radius_m);
        all[QStringLiteral("size_row_%1").arg(qRound(1e3 * radius_m))] = std::move(row);
    }
    for (const auto& [name, force] : {std::pair{"quiet", 0.0}, {"low", 0.8}, {"high", 3.7}, {"over", 4.4}}) {
        auto sign = std::make_unique<SoundSign>(theme);
        SoundCues cues;
        cues.force_N = force;
        cues.contacts = force > 0.0 ? 1 : 0;
        sign->show(cues, true, 1'000'000'000);
        all[QStringLiteral("sound_sign_%1").arg(QLatin1String(name))] = std::move(sign);
    }
    // ---- plots and charts ----
    for (const bool banded : {false, true}) {
        auto plot = std::make_unique<LivePlot>(theme, locale, QStringLiteral("Force (N)"), 2.0,
                                               banded ? std::optional<double>() : std::optional<double>(4.0));
        if (banded)
            plot->setBand(1.05, 1.35);
        for (int i = 0; i < 14'000; ++i)
            if (i < 9000 || i > 9600) // a pause
                plot->add(1e-3 * i, (banded ? 1.2 : 2.6) * (1.0 + std::sin(2e-3 * i)));
        all[banded ? QStringLiteral("live_plot_band") : QStringLiteral("live_plot_limit")] = std::move(plot);
    }
    auto chart = std::make_unique<LatenessChart>(theme, locale);
    session::LatenessBins bins;
    bins.counts = {40, 3000, 52'000, 31'000, 9000, 700, 90, 12, 3, 0, 1};
    chart->setBins(bins);
    all[QStringLiteral("lateness_chart")] = std::move(chart);
    report::MetricRow row;
    row.value = 14.0;
    row.unit = QStringLiteral("%");
    row.gateMaximum = 10.0;
    row.bandLow = 2.9;
    row.bandHigh = 25.5;
    all[QStringLiteral("band_bar_gate")] = std::make_unique<BandBar>(theme, row);
    row.gateMaximum.reset();
    row.gateMinimum = 12.0;
    row.bandLow.reset();
    row.bandHigh.reset();
    all[QStringLiteral("band_bar_minimum")] = std::make_unique<BandBar>(theme, row);
    row.value = -4.0; // below zero there is room, too
    all[QStringLiteral("band_bar_below_zero")] = std::make_unique<BandBar>(theme, row);
    for (const Pictogram picture :
         {Pictogram::moveMouse, Pictogram::wheelTowards, Pictogram::wheelAway, Pictogram::leftClick,
          Pictogram::leftHeld, Pictogram::rightHeld, Pictogram::moveStylus, Pictogram::pressStylus,
          Pictogram::stylusButton, Pictogram::keys})
        all[QStringLiteral("pictogram_%1").arg(static_cast<int>(picture))] =
            std::make_unique<MousePictogram>(theme, picture);
    auto scrubber = std::make_unique<Scrubber>(theme);
    session::PlaybackTrack track;
    track.duration_s = 40.0;
    for (int i = 0; i < 2; ++i) {
        session::PlaybackTrial trial;
        trial.index = i;
        trial.start_s = 2.0 + 20.0 * i;
        trial.end_s = 18.0 + 20.0 * i;
        track.trials.push_back(trial);
    }
    track.paused = {{9.0, 12.0}};
    namespace mark_kinds = session::mark_kinds;
    for (const auto& [t_s, end_s, kind] : {std::tuple{5.0, 6.5, mark_kinds::kOverLimit},
                                           {18.0, 18.0, mark_kinds::kMarked},
                                           {30.0, 30.0, mark_kinds::kSlipped},
                                           {38.0, 38.0, mark_kinds::kTimedOut}}) {
        session::PlaybackMark mark;
        mark.t_s = t_s;
        mark.end_s = end_s;
        mark.kind = kind;
        track.marks.push_back(mark);
    }
    scrubber->setTrack(track, "sphere_apex", {});
    scrubber->setComments({25.0});
    scrubber->setPosition(14.0);
    all[QStringLiteral("scrubber")] = std::move(scrubber);
    all[QStringLiteral("palpation_map")] = palpationMap(theme, locale);
    all[QStringLiteral("meanings")] = meanings(theme);
    for (const bool chips : {false, true})
        all[chips ? QStringLiteral("cells_chips") : QStringLiteral("cells_plain")] = cells(theme, chips);
    // ---- what an exercise and a comparison look like ----
    for (const catalogue::Exercise& exercise : catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            all[QStringLiteral("picture_%1_%2").arg(QString::fromStdString(exercise.id)).arg(level.number)] =
                std::make_unique<ExercisePicture>(theme, level, QSize(theme.px(240), theme.px(150)));
    catalogue::ExerciseLevel dimpled =
        *catalogue.find("sphere_apex", 1); // seen, as a level of one's own may have it
    dimpled.parameters.as<simulation::SphereApexParameters>().dimpleDepth_m = 0.002;
    all[QStringLiteral("picture_dimple_seen")] =
        std::make_unique<ExercisePicture>(theme, dimpled, QSize(theme.px(240), theme.px(150)));
    for (const bool hooked : {false, true}) {
        PlacesSetup setup;
        setup.hooked = hooked;
        setup.names = {QStringLiteral("left"), QStringLiteral("middle"), QStringLiteral("right")};
        auto view = std::make_unique<PlacesView>(theme, setup);
        haptics::DisplayState state;
        state.tools = 1;
        state.tool[0].p_WT_m = state.tool[0].p_WProxy_m = {0.012, -0.004, 0.020};
        PlacesView::Now now;
        now.objects = true;
        now.touched = 5;
        now.place = hooked ? 1 : 2;
        now.feltNothing = hooked;
        now.force_N = 2.2;
        view->show(state, now);
        view->setMarks({QStringLiteral("2nd"), {}, QStringLiteral("1st")});
        all[hooked ? QStringLiteral("places_hooked") : QStringLiteral("places_pads")] = std::move(view);
    }
    return all;
}

/// Counts how often a widget or a part of it is painted.
class Paints : public QObject {
public:
    explicit Paints(QWidget& of) {
        of.installEventFilter(this);
        for (QWidget* part : of.findChildren<QWidget*>())
            part->installEventFilter(this);
    }
    int count = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
};

/// What changes what a widget shows, by its name.
using Changes = std::vector<std::pair<const char*, std::function<void()>>>;

} // namespace

class TestKeptWidgets : public QObject {
    Q_OBJECT
private slots:
    void isAsItWasLookedAt_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("theme");
        QTest::addColumn<double>("scale");
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        for (const auto& [name, widget] : widgets(theme, QLocale::c(), m_catalogue)) {
            QTest::newRow(qPrintable(name)) << name << static_cast<int>(ThemeName::light) << 1.0;
            QTest::newRow(qPrintable(name + QStringLiteral(" dark, larger")))
                << name << static_cast<int>(ThemeName::dark) << 1.5;
        }
    }
    void isAsItWasLookedAt() {
        QFETCH(QString, name);
        QFETCH(int, theme);
        QFETCH(double, scale);
        const Theme look = Theme::load(static_cast<ThemeName>(theme), scale).value();
        qApp->setFont(look.font(TextStyle::body));
        qApp->setPalette(look.palette());
        qApp->setStyleSheet(look.styleSheet());
        auto all = widgets(look, QLocale(QLocale::English, QLocale::UnitedKingdom), m_catalogue);
        QWidget& widget = *all.at(name);
        const QSize size = widget.sizeHint()
                               .expandedTo(widget.minimumSizeHint())
                               .expandedTo(QSize(look.px(60), look.px(16)));
        widget.resize(name.startsWith(QLatin1String("places")) ? QSize(look.px(640), look.px(420))
                      : size.width() < look.px(200) && size.width() < size.height() * 4
                          ? size
                          : QSize(look.px(420), std::max(size.height(), look.px(24))));
        const QString differs =
            m_kept.differs(QLatin1String(QTest::currentDataTag()), widget.grab().toImage());
        const QString outline =
            m_outlines.differs(QLatin1String(QTest::currentDataTag()), tests::OutlineDevice::of(widget));
        QVERIFY2(outline.isEmpty(), qPrintable(outline));
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    void nothingElseIsKept() { QCOMPARE(m_outlines.unseen(), QStringList()); }

    void aScrubberOfNothingHasItsPlaces() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        Scrubber scrubber(theme);
        scrubber.resize(400, 52);
        QCOMPARE(scrubber.xOf(0.0), 12.0);
        QCOMPARE(scrubber.xOf(3.0), 12.0);
    }

    /// At once, and not when something else happens to paint the window.
    void whatIsNewIsPainted() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        const QLocale locale(QLocale::English, QLocale::UnitedKingdom);
        ForceBar force(theme, locale, {QStringLiteral("Force"), QStringLiteral("N"), 4.0, 2}, true);
        TargetBar target(theme, locale, {QStringLiteral("Tension"), QStringLiteral("N"), 3.0, 2}, true);
        SignedBar along(theme, locale,
                        {QStringLiteral("Fx"), QStringLiteral("Force along x"), QStringLiteral("N"), 2.0, 2},
                        true, true);
        LeanDial lean(theme, locale, 1);
        SizeRow size(theme, locale, 0.0075);
        SoundSign sound(theme);
        SoundCues cues;
        cues.force_N = 0.8;
        cues.contacts = 1;
        LatenessChart chart(theme, locale);
        session::LatenessBins bins;
        bins.counts = {40, 3000, 52'000, 31'000, 9000, 700, 90, 12, 3, 0, 1};
        Scrubber scrubber(theme);
        session::PlaybackTrack track;
        track.duration_s = 40.0;
        PlacesSetup setup;
        setup.names = {QStringLiteral("left"), QStringLiteral("middle"), QStringLiteral("right")};
        PlacesView places(theme, setup);
        PlacesView::Now now;
        now.objects = true;
        const std::vector<std::pair<QWidget*, Changes>> all{
            {&force, {{"a force", [&] { force.setValue(2.0); }}}},
            {&target,
             {{"a band", [&] { target.setBand(1.05, 1.35); }},
              {"a limit", [&] { target.setLimit(2.5); }},
              {"a tension", [&] { target.setValue(1.2); }}}},
            {&along, {{"a force along x", [&] { along.setValue(-1.4); }}}},
            {&lean, {{"a lean", [&] { lean.setLean(0, 0.2, -0.15, false); }}}},
            {&size, {{"a size", [&] { size.setRadius(0.003); }}}},
            {&sound, {{"a sound", [&] { sound.show(cues, true, 1'000'000'000); }}}},
            {&chart, {{"how late it was", [&] { chart.setBins(bins); }}}},
            {&scrubber,
             {{"a recording", [&] { scrubber.setTrack(track, "sphere_apex", {}); }},
              {"another of its length", [&] { scrubber.setTrack(track, "urethra_insertion", {}); }},
              {"comments", [&] { scrubber.setComments({25.0}); }},
              {"a moment", [&] { scrubber.setPosition(14.0); }}}},
            {&places,
             {{"objects", [&] { places.show({}, now); }},
              {"marks", [&] {
                   places.setMarks({QStringLiteral("1st"), {}, {}});
               }}}}};
        for (const auto& [widget, changes] : all) {
            widget->resize(420, 200);
            widget->show();
            QVERIFY(QTest::qWaitForWindowExposed(widget));
            Paints paints(*widget);
            for (const auto& [name, change] : changes) {
                QTest::qWait(20); // until it rests
                paints.count = 0;
                change();
                QTRY_VERIFY2_WITH_TIMEOUT(paints.count > 0, name, tests::kPatience_ms);
            }
            widget->hide();
        }
    }

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    tests::KeptPictures m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/training/kept_widgets.json")};
    tests::KeptText m_outlines{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/training/kept_widgets.txt"),
                               &tests::KeptText::nearly};
};

QTEST_MAIN(TestKeptWidgets)
#include "test_kept_widgets.moc"
