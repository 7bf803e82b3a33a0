// SPDX-License-Identifier: GPL-3.0-or-later
// What every exercise has to keep to, asked of each that is shipped: its content in every language, pictures
// and scenes, truth, metrics and gates, one score from every source, replay, bounds of force, and the screens
// and the report of a session. Its levels come from the catalogue, so that a new exercise is asked as soon as
// it is listed. By default the first level of each; CHIRON_EVERY_LEVEL=1: all of them.
#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "database/repositories/score_repository.h"
#include "desktop/debrief/debrief_data.h"
#include "desktop/debrief/report_words.h"
#include "desktop/exercise_face.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/scene3d/scene_plugin.h"
#include "desktop/training/info_view.h"
#include "desktop/training/scene_feed.h"
#include "desktop/widgets/state_panel.h"
#include "devices/kinematics_catalogue.h"
#include "exercises/conformance/simulated_again.h"
#include "recording/wrench_rounding.h"
#include "report/report_writer.h"
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "session_report/mark_words.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"
#include "support/pdf_text.h"

#include <QDir>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <cmath>
#include <map>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;

namespace {

constexpr QSize kScene(900, 600), kPicture(240, 150);
constexpr desktop::ThemeName kThemes[] = {desktop::ThemeName::light, desktop::ThemeName::dark};

template <class T> T valueOf(core::Result<T> result) {
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return std::move(*result);
}

/// What was seen of a session while it was simulated again.
struct SeenAgain {
    std::vector<haptics::DisplayState>
        moments; ///< as a window gets them: a trial begins, is felt most, and ends
    std::uint64_t touching_ticks = 0;
    std::uint64_t air_ticks = 0;       ///< the scene says of no tool that it touches anything
    std::map<QString, QString> broken; ///< what did not hold, and where it first did not
};

/// A session of one trial, done by an operator in the name of a trainee.
struct Done {
    database::SessionId session = 0;
    bool felt = false;
    scoring::ScoreCard live;
    SeenAgain seen;
};

/// What devices can give, and what scenes may: looked at tick by tick.
class ForceBounds {
public:
    ForceBounds(const session::SessionSetup& setup, SeenAgain& seen) : m_setup(setup), m_seen(seen) {
        for (std::size_t i = 0; i < setup.devices.size(); ++i) {
            m_kinematics.push_back(valueOf(devices::makeKinematics(setup.devices[i])));
            m_maps.emplace_back(setup.mappings[i]);
        }
    }

    void look(const tests::TickAgain& tick) {
        // models.md §7: nothing in free air. Of several tools none touches where the scene holds no energy
        // and no stiffness.
        const bool air = tick.scene.storedEnergy_J == 0.0 && tick.scene.contactStiffness_N_per_m == 0.0;
        bool touching = false;
        for (std::size_t i = 0; i < m_kinematics.size(); ++i) {
            const core::ToolFrame& tool = tick.frame.tool[i];
            const core::Wrench tissue = core::toWrench(tool.tissue);
            hold(tick, i, "what was recorded is the force of the loop, rounded",
                 recording::roundedWrench(tool.tissue) == tick.recorded.tool[i].tissue &&
                     recording::roundedWrench(tool.commanded) == tick.recorded.tool[i].commanded);
            hold(tick, i, "tissue answers with numbers",
                 tissue.force.allFinite() && tissue.torque.allFinite());
            hold(tick, i, "tissue pushes nothing in the air",
                 !air || (tissue.force.isZero(0.0) && tissue.torque.isZero(0.0)));
            holdToDevice(tick, i);
            touching = touching || !tissue.force.isZero(0.0);
        }
        m_seen.air_ticks += air ? 1 : 0;
        m_seen.touching_ticks += touching ? 1 : 0;
    }

private:
    void hold(const tests::TickAgain& tick, std::size_t tool, const char* what, bool holds) {
        if (!holds)
            m_seen.broken.try_emplace(
                QLatin1String(what),
                QStringLiteral("tick %1, tool %2").arg(tick.frame.header.index).arg(tool));
    }

    void holdToDevice(const tests::TickAgain& tick, std::size_t i) {
        const devices::DeviceDescriptor& device = m_setup.devices[i];
        const core::Wrench commanded = core::toWrench(tick.frame.tool[i].commanded);
        hold(tick, i, "no force beyond the device's",
             commanded.force.norm() <= (device.rendersForce ? device.maximumForce_N : 0.0));
        hold(tick, i, "no torque beyond the device's",
             commanded.torque.norm() <= (device.rendersForce ? device.maximumTorque_Nm : 0.0));
        const auto efforts = m_kinematics[i]->efforts(session::sampleOf(tick.recorded.tool[i]),
                                                      m_maps[i].wrenchToD(commanded));
        for (std::size_t axis = 0; axis < device.axes.size();
             ++axis) // one without a motor carries what is commanded by its bearing
            hold(tick, i, "no axis beyond its rating",
                 device.axes[axis].continuousRating <= 0.0 ||
                     std::abs(efforts[axis]) <= device.axes[axis].continuousRating);
        hold(tick, i, "no pad beyond the device's",
             tick.shown.tool[i].safeDisplay[0] <= device.maximumForce_N);
    }

    const session::SessionSetup& m_setup;
    SeenAgain& m_seen;
    std::vector<std::unique_ptr<devices::IToolKinematics>> m_kinematics;
    std::vector<devices::WorkspaceMap> m_maps;
};

/// Keeps what a window would show when a trial has just begun, where it is felt most, and last.
class Moments {
public:
    void look(const tests::TickAgain& tick) {
        if (tick.shown.phase != core::TrialPhase::running)
            return;
        double force_N = 0.0;
        for (int i = 0; i < tick.shown.tools; ++i)
            force_N += core::toWrench(tick.shown.tool[static_cast<std::size_t>(i)].tissue).force.norm();
        if (!m_any)
            m_first = m_most = tick.shown;
        if (force_N > m_most_N) {
            m_most_N = force_N;
            m_most = tick.shown;
        }
        m_last = tick.shown;
        m_any = true;
    }
    std::vector<haptics::DisplayState> take() const {
        return m_any ? std::vector{m_first, m_most, m_last} : std::vector<haptics::DisplayState>();
    }

private:
    bool m_any = false;
    double m_most_N = 0.0;
    haptics::DisplayState m_first, m_most, m_last;
};

QStringList lackingIn(const catalogue::Translated& text, const QString& what) {
    QStringList lacking;
    for (const std::string& language : core::languageIds()) {
        const auto found = text.find(language);
        if (found == text.end() || QString::fromStdString(found->second).trimmed().isEmpty())
            lacking << QStringLiteral("%1 in \"%2\"").arg(what, QString::fromStdString(language));
    }
    return lacking;
}

/// How much of a picture is not as in another one of its size, 0..1.
double differingShare(const QImage& a, const QImage& b) {
    std::int64_t differing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            differing += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return static_cast<double>(differing) / (static_cast<double>(a.width()) * a.height());
}

QImage flatPicture(const scene3d::SceneSetup& setup, const scene3d::SceneState& state) {
    const auto view = scene3d::makeFlatSceneView(setup, {}, nullptr);
    view->widget()->resize(kScene);
    view->show(state);
    return view->widget()->grab().toImage();
}

/// The canvas without what lies in the field.
QImage emptyFlatPicture(scene3d::SceneSetup setup, const scene3d::SceneState& state) {
    setup.exercise.clear();
    return flatPicture(setup, state);
}

/// Why a metric has no value is told by one of the known reasons.
QStringList undefinedIn(const std::vector<scoring::MetricValue>& metrics) {
    QStringList wrong;
    for (const scoring::MetricValue& metric : metrics) {
        const bool holds = metric.value ? std::isfinite(*metric.value) && metric.reason.empty()
                                        : scoring::undefinedOf(metric.reason).has_value();
        if (!holds)
            wrong << QStringLiteral("%1: %2 \"%3\"")
                         .arg(QString::fromStdString(metric.id))
                         .arg(metric.value.value_or(NAN))
                         .arg(QString::fromStdString(metric.reason));
    }
    return wrong;
}

QStringList reasonsOf(const scoring::ScoreCard& card) {
    QStringList reasons;
    for (const scoring::MetricValue& metric : card.metrics)
        reasons << QString::fromStdString(metric.reason);
    for (const auto& trial : card.trials)
        for (const scoring::MetricValue& metric : trial)
            reasons << QString::fromStdString(metric.reason);
    return reasons;
}

/// The first value that differs, in words.
QString difference(const scoring::ScoreCard& a, const scoring::ScoreCard& b) {
    const auto told = [](const scoring::MetricValue& metric) {
        return metric.value ? QString::number(*metric.value, 'g', 17) : QString::fromStdString(metric.reason);
    };
    for (std::size_t i = 0; i < std::min(a.metrics.size(), b.metrics.size()); ++i)
        if (told(a.metrics[i]) != told(b.metrics[i]))
            return QStringLiteral("%1: %2 and %3")
                .arg(QString::fromStdString(a.metrics[i].id), told(a.metrics[i]), told(b.metrics[i]));
    return QStringLiteral("%1 and %2 trials, %3 and %4 metrics")
        .arg(a.trials.size())
        .arg(b.trials.size())
        .arg(a.metrics.size())
        .arg(b.metrics.size());
}

bool isSame(const scoring::ScoreCard& a, const scoring::ScoreCard& b) {
    return session::sameScores(a, b) && reasonsOf(a) == reasonsOf(b);
}

} // namespace

class TestConformance : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup() { speak(QStringLiteral("en")); }

    void contentIsThereInEveryLanguage_data() { addLevels(); }
    void contentIsThereInEveryLanguage();
    void levelFactsAreToldInEveryLanguage_data() { addLevels(); }
    void levelFactsAreToldInEveryLanguage();
    void pictureIsPainted_data() { addLevels(); }
    void pictureIsPainted();
    void gatesAreOnMetricsAndHaveAdvice_data() { addLevels(); }
    void gatesAreOnMetricsAndHaveAdvice();
    void demonstrationShowsItsOwn_data() { addLevels(); }
    void demonstrationShowsItsOwn();
    void operatorComesToTheEnd_data() { addLevels(); }
    void operatorComesToTheEnd();
    void everyTrialHasItsTruth_data() { addLevels(); }
    void everyTrialHasItsTruth();
    void metricsAreDefinedOrSayWhyNot_data() { addLevels(); }
    void metricsAreDefinedOrSayWhyNot();
    void scoreIsTheSameLiveStoredAndExported_data() { addLevels(); }
    void scoreIsTheSameLiveStoredAndExported();
    void replayIsIdentical_data() { addLevels(); }
    void replayIsIdentical();
    void forceKeepsToItsBounds_data() { addLevels(); }
    void forceKeepsToItsBounds();
    void liveSceneIsDrawn_data() { addLevels(); }
    void liveSceneIsDrawn();
    void playedSceneIsDrawn_data() { addLevels(); }
    void playedSceneIsDrawn();
    void screensAndReportOpen_data() { addLevels(); }
    void screensAndReportOpen();

private:
    using MakeSetup = std::function<scene3d::SceneSetup(const desktop::Theme&)>;
    using MakeState = std::function<scene3d::SceneState(std::size_t moment)>;
    /// A stored session with the connection that it lives on.
    struct Stored {
        std::unique_ptr<database::Connection> connection;
        std::unique_ptr<session::SessionView> view;
    };

    void addLevels();
    const catalogue::Exercise& exercise();
    const catalogue::ExerciseLevel& level();
    const desktop::ExerciseFace& face() { return *valueOf(desktop::exerciseFace(exercise().id)); }
    const session::ExerciseKind& kind() { return *valueOf(session::exerciseKind(exercise().id)); }
    const Done& done();
    Done run();
    Stored open(database::SessionId id);
    void speak(const QString& language);
    void isDrawn(const MakeSetup& makeSetup, std::size_t moments, const MakeState& makeState, bool moves);
    void opens(const QString& screen, const QVariantMap& place);
    void isPrinted(database::SessionId id, const std::string& language);

    std::unique_ptr<DesktopFixture> m_site;
    std::optional<database::Actor> m_tina;
    scene3d::ScenePlugin m_plugin;
    std::map<QString, Done> m_done; ///< by row
};

void TestConformance::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_tina = m_site->actor("tina");
    m_site->context.logIn(*m_tina);
    m_plugin = scene3d::loadScenePlugin(QStringLiteral(CHIRON_BINARY_DIR "/app/desktop"));
    QVERIFY2(m_plugin.make, qPrintable(m_plugin.why));
}

void TestConformance::addLevels() {
    QTest::addColumn<QString>("exerciseId");
    QTest::addColumn<int>("number");
    const bool all = qEnvironmentVariableIntValue("CHIRON_EVERY_LEVEL") != 0;
    for (const catalogue::Exercise& exercise : m_site->context.site().catalogue().exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            if (all || level.number == 1)
                QTest::addRow("%s %d", exercise.id.c_str(), level.number)
                    << QString::fromStdString(exercise.id) << level.number;
}

const catalogue::Exercise& TestConformance::exercise() {
    QFETCH(QString, exerciseId);
    return *m_site->context.site().catalogue().find(exerciseId.toStdString());
}

const catalogue::ExerciseLevel& TestConformance::level() {
    QFETCH(int, number);
    return *m_site->context.site().catalogue().find(exercise().id, number);
}

/// The session of this row's level, which is done once.
const Done& TestConformance::done() {
    const QString row = QString::fromUtf8(QTest::currentDataTag());
    auto found = m_done.find(row);
    if (found == m_done.end())
        found = m_done.emplace(row, run()).first;
    return found->second;
}

Done TestConformance::run() {
    const std::vector<std::string> names = kind().operatorNames();
    const bool hasExpert = std::find(names.begin(), names.end(), "expert") != names.end();
    session::TrainingRequest request;
    request.level = valueOf(catalogue::withTrials(level(), 1));
    request.seed = 11;
    request.ringFolder = recording::defaultRingFolder();
    request.station = valueOf(
        session::scriptedStation(kind(), request.level, hasExpert ? "expert" : names.at(0), request.seed));
    request.station.operatorName.clear(); // as if by Tina's own hand
    Done done;
    done.felt = request.station.felt();
    const session::TrainingResult result =
        valueOf(session::runTraining(m_site->database(), *m_tina, std::move(request)));
    done.session = result.session;
    done.live = result.scores;
    const Stored stored = open(done.session);
    ForceBounds bounds(stored.view->setup(), done.seen);
    Moments moments;
    const auto seen = tests::simulateAgain(*stored.view, [&](const tests::TickAgain& tick) {
        bounds.look(tick);
        moments.look(tick);
    });
    if (!seen)
        qFatal("%s", seen.error().message.c_str());
    done.seen.moments = moments.take();
    return done;
}

TestConformance::Stored TestConformance::open(database::SessionId id) {
    Stored stored;
    stored.connection = valueOf(m_site->database().openReader());
    stored.view = valueOf(session::SessionView::open(*stored.connection, *m_tina, id));
    return stored;
}

void TestConformance::speak(const QString& language) {
    if (m_site->settings.language() == language)
        return;
    m_site->settings.setLanguage(language);
    m_site->context.applyAppearance();
}

void TestConformance::contentIsThereInEveryLanguage() {
    QStringList lacking = lackingIn(exercise().title, QStringLiteral("the exercise's title"));
    lacking += lackingIn(exercise().objective, QStringLiteral("the exercise's objective"));
    for (const catalogue::LegendLine& line : exercise().legend)
        lacking += lackingIn(line.text, QStringLiteral("the legend of ") + QString::fromStdString(line.mark));
    lacking += lackingIn(level().title, QStringLiteral("title"));
    lacking += lackingIn(level().goal, QStringLiteral("goal"));
    lacking += lackingIn(level().objective, QStringLiteral("objective"));
    lacking += lackingIn(level().measured, QStringLiteral("what is measured"));
    if (level().shownForce)
        lacking += lackingIn(level().shownForce->note, QStringLiteral("note on force that is shown"));
    QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join(QLatin1Char('\n'))));
}

/// An exercise may have none (ExerciseFace::levelFacts); those that it has are told in every language, and
/// not in English alone.
void TestConformance::levelFactsAreToldInEveryLanguage() {
    std::optional<QStringList> english;
    for (const std::string& language : core::languageIds()) {
        speak(QString::fromStdString(language));
        const QStringList facts = face().levelFacts(level(), m_site->context.locale());
        for (const QString& fact : facts)
            QVERIFY2(!fact.trimmed().isEmpty(), language.c_str());
        if (!english)
            english = facts;
        else
            QVERIFY2(facts.size() == english->size() && (facts.isEmpty() || facts != *english),
                     qPrintable(facts.join(QLatin1Char('\n'))));
    }
}

void TestConformance::pictureIsPainted() {
    for (const desktop::ThemeName name : kThemes) {
        const desktop::Theme theme = valueOf(desktop::Theme::load(name, 1.0));
        for (const bool objectShown : {true, false}) {
            const auto picture = face().picture(level(), {theme, kPicture, objectShown});
            QVERIFY(picture);
            QImage ground(kPicture, QImage::Format_RGB32);
            ground.fill(theme.color(desktop::Colour::sceneBackground));
            QImage image = ground;
            QPainter painter(&image);
            picture->paint(painter);
            painter.end();
            const double share = differingShare(image, ground);
            QVERIFY2(share > 0.01, qPrintable(QString::number(share)));
        }
    }
}

void TestConformance::gatesAreOnMetricsAndHaveAdvice() {
    QVERIFY(!level().metrics.empty());
    for (const catalogue::MetricChoice& metric : level().metrics)
        QVERIFY2(scoring::findMetric(metric.id, metric.version) != nullptr, metric.id.c_str());
    QVERIFY(!level().gates.empty());
    for (const scoring::Gate& gate : level().gates) {
        const auto& metrics = level().metrics;
        QVERIFY2(std::any_of(metrics.begin(), metrics.end(),
                             [&](const auto& metric) { return metric.id == gate.metric; }),
                 gate.metric.c_str());
        QVERIFY2(gate.minimum || gate.maximum, gate.metric.c_str());
        QVERIFY2(!gate.minimum || !gate.maximum || *gate.minimum <= *gate.maximum, gate.metric.c_str());
        const auto& all = exercise().advice;
        const auto advice = std::find_if(all.begin(), all.end(), [&](const catalogue::Advice& each) {
            return each.metric == gate.metric;
        });
        const QStringList lacking = lackingIn(advice == all.end() ? catalogue::Translated() : advice->text,
                                              QString::fromStdString(gate.metric));
        QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join(QLatin1Char('\n'))));
    }
}

/// The demonstration names only metrics that some level of the exercise has, and levels that exist.
void TestConformance::demonstrationShowsItsOwn() {
    const auto hasMetric = [this](const std::string& id) {
        const auto& levels = exercise().levels;
        return std::any_of(levels.begin(), levels.end(), [&](const catalogue::ExerciseLevel& each) {
            return std::any_of(each.metrics.begin(), each.metrics.end(),
                               [&](const auto& metric) { return metric.id == id; });
        });
    };
    const session::Demonstration shown = kind().demonstration();
    QCOMPARE(shown.columns.empty(), shown.legend.empty());
    for (const session::DemoColumn& column : shown.columns)
        QVERIFY2(hasMetric(column.metric) && !column.heading.empty(), column.metric.c_str());
    const int levels = static_cast<int>(exercise().levels.size());
    if (shown.comparison)
        QVERIFY2(hasMetric(shown.comparison->metric) && shown.comparison->level <= levels &&
                     shown.comparison->file.ends_with(".png"),
                 shown.comparison->metric.c_str());
    QVERIFY(!shown.report || (shown.report->level >= 1 && shown.report->level <= levels));
}

void TestConformance::operatorComesToTheEnd() {
    const Stored stored = open(done().session);
    QCOMPARE(stored.view->record().summary.state, database::SessionState::completed);
    database::SessionReader reader(*stored.connection, *m_tina);
    const auto trials = valueOf(reader.trials(done().session));
    QCOMPARE(static_cast<int>(trials.size()), kind().trialCount(stored.view->setup().level));
    for (const database::TrialRecord& trial : trials)
        QVERIFY2(trial.marked && !trial.timedOut && trial.state == database::SessionState::completed,
                 trial.sceneJson.c_str());
}

/// Whatever trial there was, its truth is known to metrics, stored beside it and drawn in playback.
void TestConformance::everyTrialHasItsTruth() {
    const Stored stored = open(done().session);
    const auto surfaces = kind().makeSurfaces(stored.view->setup().level, stored.view->setup().seed);
    QVERIFY(surfaces);
    const auto trace = valueOf(stored.view->trace());
    database::SessionReader reader(*stored.connection, *m_tina);
    const auto trials = valueOf(reader.trials(done().session));
    QVERIFY(!trace->trials.empty());
    QCOMPARE(trace->trials.size(), trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const scoring::TrialTrace& trial = trace->trials[i];
        if (const auto object = surfaces->object(
                trial.trial)) // what is not an object (a canal) is drawn from the level alone
            QVERIFY2(object->p_WObject.allFinite() && std::isfinite(object->radius_m),
                     "the object lies nowhere");
        QVERIFY2(trial.target || trial.own || !trial.truth.empty(), "metrics know nothing of it");
        for (const scoring::NamedValue& value : trial.truth)
            QVERIFY2(!value.id.empty() && std::isfinite(value.value), value.id.c_str());
        const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(trials[i].sceneJson));
        QVERIFY2(json.isObject() && !json.object().isEmpty(), trials[i].sceneJson.c_str());
        for (const scoring::NamedValue& value : trial.truth)
            QCOMPARE(json.object().value(QString::fromStdString(value.id)).toDouble(NAN), value.value);
    }
    const int planned = static_cast<int>(trials.size());
    QVERIFY(!surfaces->object(planned)); // nothing is told of a trial that is not planned
    for (const int number : {-1, planned}) {
        scoring::TrialTrace beyond;
        beyond.trial = number;
        kind().addTruth(stored.view->setup().level, stored.view->setup().seed, beyond);
        QVERIFY2(beyond.truth.empty() && !beyond.target, qPrintable(QString::number(number)));
    }
}

void TestConformance::metricsAreDefinedOrSayWhyNot() {
    const scoring::ScoreCard& card = done().live;
    QCOMPARE(card.metrics.size(), level().metrics.size());
    for (std::size_t i = 0; i < card.metrics.size(); ++i) {
        QCOMPARE(card.metrics[i].id, level().metrics[i].id);
        QCOMPARE(card.metrics[i].version, level().metrics[i].version);
        const auto& gates = level().gates;
        QCOMPARE(card.metrics[i].passed.has_value(),
                 std::any_of(gates.begin(), gates.end(),
                             [&](const auto& gate) { return gate.metric == card.metrics[i].id; }));
    }
    QStringList wrong = undefinedIn(card.metrics);
    QVERIFY(!card.trials.empty());
    for (const auto& trial : card.trials)
        wrong += undefinedIn(trial);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    QVERIFY(std::any_of(card.metrics.begin(), card.metrics.end(),
                        [](const auto& metric) { return metric.value.has_value(); }));
}

void TestConformance::scoreIsTheSameLiveStoredAndExported() {
    const Stored stored = open(done().session);
    const scoring::ScoreCard& live = done().live;
    const auto kept = valueOf(database::ScoreRepository(*stored.connection, *m_tina).scores(done().session));
    QVERIFY2(isSame(kept, live), qPrintable(difference(kept, live)));
    const auto recomputed = valueOf(stored.view->computeScores());
    QVERIFY2(isSame(recomputed, live), qPrintable(difference(recomputed, live)));

    const QString file = QDir(m_site->folder()).filePath(QStringLiteral("trace.csv"));
    const auto written = session::exportCsv(*stored.view, file);
    QVERIFY2(written, written ? "" : written.error().message.c_str());
    const auto rows = valueOf(scoring::readTraceCsvFile(file.toStdString()));
    const auto trace = valueOf(scoring::buildSessionTrace(rows, exercise().id));
    std::vector<scoring::MetricRequest> wanted;
    for (const catalogue::MetricChoice& metric : level().metrics)
        wanted.push_back({metric.id, metric.version});
    const bool completed = stored.view->record().summary.state == database::SessionState::completed;
    const auto exported = valueOf(scoring::calculateScore(trace, wanted, level().gates, completed));
    QVERIFY2(isSame(exported, live), qPrintable(difference(exported, live)));
    QFile::remove(file);
}

void TestConformance::replayIsIdentical() {
    const Stored stored = open(done().session);
    const auto report = valueOf(session::replaySession(*stored.view));
    QVERIFY2(report.comparable, report.note.c_str());
    QVERIFY(report.frames > 0);
    QVERIFY2(report.identical,
             qPrintable(QStringLiteral("differs from tick %1").arg(report.firstDifferentTick.value_or(0))));
    QCOMPARE(report.maximumDifference_N, 0.0);
}

void TestConformance::forceKeepsToItsBounds() {
    const SeenAgain& seen = done().seen;
    QStringList broken;
    for (const auto& [what, where] : seen.broken)
        broken << what + QStringLiteral(": not at ") + where;
    QVERIFY2(broken.isEmpty(), qPrintable(broken.join(QLatin1Char('\n'))));
    QVERIFY2(seen.touching_ticks > 0 && seen.air_ticks > 0,
             "of a session without contact, or without air, nothing is shown");
}

/// Flat in the light and the dark theme, and in 3D where the exercise has a stage (scene_catalogue.cpp); else
/// flat is all that there is.
void TestConformance::isDrawn(const MakeSetup& makeSetup, std::size_t moments, const MakeState& makeState,
                              bool moves) {
    QVERIFY2(moments > 0, "there is nothing to be seen");
    std::vector<QImage> inThemes;
    scene3d::SceneSetup setup;
    for (const desktop::ThemeName name : kThemes) {
        setup = makeSetup(valueOf(desktop::Theme::load(name, 1.0)));
        QVERIFY(scene3d::makeFlatContent(setup));
        std::vector<QImage> pictures;
        for (std::size_t moment = 0; moment < moments; ++moment) {
            const scene3d::SceneState state = makeState(moment);
            pictures.push_back(flatPicture(setup, state));
            const double share = differingShare(pictures.back(), emptyFlatPicture(setup, state));
            QVERIFY2(share > 0.01, qPrintable(QStringLiteral("moment %1: %2").arg(moment).arg(share)));
        }
        QVERIFY2(!moves || std::any_of(pictures.begin(), pictures.end(),
                                       [&](const QImage& picture) { return picture != pictures.front(); }),
                 "nothing ever moves");
        inThemes.push_back(pictures.front());
    }
    QVERIFY(inThemes.at(0) != inThemes.at(1));
    const std::unique_ptr<scene3d::ISceneView> view(m_plugin.make(&setup, nullptr));
    if (!view)
        return;
    const auto* root = view->inputSource()->property(scene3d::kSceneRootProperty).value<QObject*>();
    QVERIFY2(root != nullptr && !root->children().isEmpty(), "its stage is empty");
    for (std::size_t moment = 0; moment < moments; ++moment)
        view->show(makeState(moment));
}

/// As the training screen draws it: what every exercise shows, and what its live part adds.
void TestConformance::liveSceneIsDrawn() {
    const session::LevelCues cues = session::cuesOf(level(), done().felt);
    const auto& shown = done().seen.moments;
    desktop::LiveSurroundings around{.theme = m_site->context.theme(),
                                     .locale = m_site->context.locale(),
                                     .cues = cues,
                                     .report = {},
                                     .freePointer = {}};
    const auto part = face().livePart(level(), std::move(around));
    QVERIFY(part);
    const std::unique_ptr<QWidget> panel(part->makePanel());
    QVERIFY(panel);
    isDrawn([&](const desktop::Theme& theme) { return desktop::sceneSetupOf(level(), cues, theme, false); },
            shown.size(),
            [&](std::size_t moment) {
                scene3d::SceneState drawn = desktop::sceneStateOf(shown[moment], cues, shown.front().now_ns);
                const session::LiveSample sample = session::liveSampleOf(shown[moment], shown.front().now_ns);
                part->show(shown[moment], {&sample, 1}, drawn);
                return drawn;
            },
            cues.tool);
}

void TestConformance::playedSceneIsDrawn() {
    const Stored stored = open(done().session);
    const auto trace = valueOf(stored.view->trace());
    const auto track = valueOf(stored.view->track());
    const auto layer = face().playbackLayer(stored.view->setup(), *trace);
    QVERIFY(layer);
    QVERIFY2(layer->lost().isEmpty(), qPrintable(layer->lost()));
    for (const desktop::PlaybackSwitch& each : layer->switches())
        layer->turn(each.key, true);
    std::vector<double> times_s;
    for (const session::PlaybackTrial& trial : track->trials)
        times_s.insert(times_s.end(), {trial.start_s, 0.5 * (trial.start_s + trial.end_s), trial.end_s});
    isDrawn(
        [&](const desktop::Theme& theme) {
            scene3d::SceneSetup setup =
                desktop::sceneSetupOf(stored.view->setup(), track->forceLimit_N, theme);
            layer->setUp(setup);
            return setup;
        },
        times_s.size(),
        [&](std::size_t moment) {
            return desktop::sceneStateAt(*track, nullptr, times_s[moment], layer.get());
        },
        true);
}

void TestConformance::screensAndReportOpen() {
    const database::SessionId id = done().session;
    const Stored stored = open(id);
    const auto trace = valueOf(stored.view->trace());
    const auto track = valueOf(stored.view->track());
    QVERIFY(!track->empty());
    for (const std::string& language : core::languageIds()) {
        speak(QString::fromStdString(language));
        const QLocale locale = m_site->context.locale();
        opens(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(id)}});
        const QString title = face().debriefTitle();
        const auto labels = m_site->window->screen()->findChildren<QLabel*>();
        QVERIFY2(std::any_of(labels.begin(), labels.end(),
                             [&](const QLabel* label) { return label->text() == title; }),
                 qPrintable(title));
        const auto part = face().readDebrief(stored.view->setup().level, *trace);
        QVERIFY2(part, part ? "" : part.error().why.message.c_str());
        QVERIFY(!*part || std::unique_ptr<QWidget>((*part)->widget(m_site->context.theme(), locale)));
        opens(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(id)}});
        const auto layer = face().playbackLayer(stored.view->setup(), *trace);
        const double middle_s = 0.5 * track->duration_s;
        QVERIFY(!layer->readout(*track, track->at(middle_s), middle_s, locale).isEmpty());
        for (const session::PlaybackMark& mark : track->marks)
            QVERIFY2(!session_report::whatHappened(mark, exercise().id, locale).isEmpty(),
                     std::string(mark.kind.id).c_str());
        opens(QStringLiteral("results"), {{QStringLiteral("exercise"), QString::fromStdString(exercise().id)},
                                          {QStringLiteral("level"), level().number}});
        isPrinted(id, language);
        if (QTest::currentTestFailed())
            return;
    }
}

/// The screen comes to its content, and no part of it fails; a part may be empty for good reasons, which it
/// says.
void TestConformance::opens(const QString& screen, const QVariantMap& place) {
    using State = desktop::StatePanel::State;
    m_site->go(screen, place);
    const auto panels = [&] { return m_site->window->screen()->findChildren<desktop::StatePanel*>(); };
    const auto loaded = [&] {
        const auto all = panels();
        return !all.isEmpty() && m_site->context.background().idle() &&
               std::none_of(all.begin(), all.end(),
                            [](const auto* panel) { return panel->state() == State::loading; });
    };
    QTRY_VERIFY_WITH_TIMEOUT(loaded(), kPatience_ms);
    QStringList said{screen};
    for (const QLabel* label : m_site->window->screen()->findChildren<QLabel*>())
        said << label->text();
    QVERIFY2(panels().front()->state() == State::content, qPrintable(said.join(QLatin1Char('\n'))));
    for (const desktop::StatePanel* panel : panels())
        QVERIFY2(panel->state() != State::error, qPrintable(said.join(QLatin1Char('\n'))));
}

void TestConformance::isPrinted(database::SessionId id, const std::string& language) {
    const auto connection = valueOf(m_site->database().openReader());
    report::ReportData data = valueOf(desktop::loadReport(*connection, *m_tina, id, language));
    const QString title = desktop::exerciseTitle(m_site->context.site().catalogue(), exercise().id,
                                                 QString::fromStdString(language));
    desktop::translateReport(data, {QStringLiteral("Tina"), title, QStringLiteral("device")});
    QCOMPARE(data.metrics.size(), level().metrics.size());
    for (const auto& metric : data.metrics)
        QVERIFY2(!metric.name.isEmpty() && metric.name != metric.id, qPrintable(metric.id));
    const QString file = QDir(m_site->folder()).filePath(QStringLiteral("report.pdf"));
    const auto written = report::writeSessionPdf(file, data, report::lightTheme(m_site->context.locale()));
    QVERIFY2(written, written ? "" : written.error().message.c_str());
    const QString text = tests::pdfText(file).simplified();
    QVERIFY2(text.contains(title), qPrintable(title));
}

QTEST_MAIN(TestConformance)
#include "test_conformance.moc"
