// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/station_screen.h"

#include "core/fp_environment.h"
#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_words.h"
#include "desktop/station/lateness_chart.h"
#include "desktop/station/platform_card.h"
#include "desktop/station/station_words.h"
#include "desktop/storage/storage_words.h"
#include "desktop/storage/task_strip.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QHBoxLayout>
#include <QTimer>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kSelfTest_ms = 10'000;

void clearColumn(QVBoxLayout& column) {
    while (QLayoutItem* item = column.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

} // namespace

StationScreen::StationScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_panel(new StatePanel(context.theme())),
      m_strip(new TaskStrip(context.theme())), m_timer(new QTimer(this)) {
    constexpr int kLook_ms = 100;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_panel, 1);
    column->addWidget(m_strip);
    m_timer->setInterval(kLook_ms);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (m_token && m_task)
            m_token->setProgress(static_cast<int>(m_task->done()), m_token->of());
    });
    connect(&context, &AppContext::trialRunsChanged, this, &StationScreen::showButton);
}

StationScreen::~StationScreen() {
    if (m_token)
        m_token->cancel();
}

QString StationScreen::title() const {
    return tr("Station");
}

QString StationScreen::help() const {
    return tr("Shows whether this computer is fast and regular enough for haptic force.\n\nForce is computed "
              "a thousand times per second. "
              "The charts show how late those thousand steps began: in the last session that ran in real "
              "time, and in a self-test of ten "
              "seconds without any device.\n\nThe fingertip platform is verified as in its publication: how "
              "closely it follows a force and "
              "an orientation. Each check is kept in the audit trail, and its record can be saved and filed: "
              "who, when, on which device and build, and each measured value beside its limit.\n\nWith "
              "real-time priority the loop stays on time whatever else the computer "
              "does. This screen shows whether the loop has that priority and how to permit it.");
}

std::vector<ScreenCommand> StationScreen::commands() {
    // Listed even before they can be used, because the palette offers them on other screens.
    return {{tr("Run the self-test"), {}, [this] { startSelfTest(); }},
            {tr("Verify the fingertip platform"), {}, [this] { startVerification(); }}};
}

void StationScreen::enter() {
    load();
}

void StationScreen::load() {
    m_panel->showLoading(tr("Checking the station …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor()](WorkToken&) {
            return readStationFacts(database, actor);
        },
        [this](const core::Result<StationFacts>& facts) {
            if (facts)
                show(*facts);
            else
                m_panel->showError(tr("The station could not be checked."), facts.error(),
                                   [this] { load(); });
        });
}

void StationScreen::show(const StationFacts& facts) {
    auto* page = new ScrollPage(context().theme(), 1000);
    page->column()->addWidget(kit::label(context().theme(), title(), TextStyle::heading));
    page->column()->addWidget(loopCard(facts));
    page->column()->addWidget(devicesCard());
    page->column()->addWidget(platformCard());
    page->column()->addWidget(roomCard(facts));
    page->column()->addStretch();
    delete m_panel->content();
    m_panel->setContent(page);
    m_panel->showContent();
    showButton();
    if (m_test)
        m_test->setFocus(Qt::OtherFocusReason);
}

QWidget* StationScreen::loopCard(const StationFacts& facts) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Timing of the force loop"), TextStyle::title));
    if (facts.last) {
        const QString when = SessionWords::ago(SessionWords::timeOf(facts.last->startedUtc),
                                               QDateTime::currentDateTimeUtc(), context().locale());
        box.layout->addWidget(
            kit::label(theme, tr("Session %1, %2").arg(facts.last->session).arg(when), TextStyle::strong));
        addLoop(*box.layout, facts.last->loop);
    } else {
        box.layout->addWidget(kit::label(
            theme,
            tr("None of the latest sessions ran in real time, so it is not yet known how well this "
               "station keeps time."),
            TextStyle::body, "muted"));
    }
    box.layout->addWidget(kit::rule());
    box.layout->addWidget(kit::label(theme, tr("Self-test without a device"), TextStyle::strong));
    m_testBox = new QVBoxLayout;
    box.layout->addLayout(m_testBox);
    if (mayCheck()) {
        m_test = kit::button(theme, tr("Run the self-test"), "primary", QStringLiteral("run-build"));
        m_test->setObjectName(QStringLiteral("station.self_test"));
        connect(m_test, &QPushButton::clicked, this, &StationScreen::startSelfTest);
        auto* row = new QWidget;
        auto* flow = new FlowLayout(theme.px(8), row);
        flow->addWidget(m_test);
        m_testRecord = kit::button(theme, tr("Record (PDF) …"), "", QStringLiteral("document-save"));
        m_testRecord->setObjectName(QStringLiteral("station.test_record"));
        m_testRecord->setAccessibleName(tr("Record of the self-test (PDF)"));
        m_testRecord->setEnabled(false);
        connect(m_testRecord, &QPushButton::clicked, this, [this] {
            saveRecord(tr("Station check.pdf"),
                       [this](const QString& path) { return writeLoopRecord(path); });
        });
        flow->addWidget(m_testRecord);
        box.layout->addWidget(row);
    } else {
        box.layout->addWidget(kit::label(theme, tr("A researcher or an administrator can run it here."),
                                         TextStyle::body, "muted"));
    }
    return box.frame;
}

void StationScreen::addLoop(QVBoxLayout& column, const session::LoopReport& loop) const {
    const Theme& theme = context().theme();
    column.addWidget(
        kit::notice(theme, StationWords::verdictKind(loop), StationWords::verdict(loop, context().locale())));
    column.addWidget(kit::label(theme, StationWords::punctuality(loop, context().locale())));
    if (loop.lateness) {
        auto* chart = new LatenessChart(theme, context().locale());
        chart->setBins(*loop.lateness);
        column.addWidget(chart);
    } else {
        column.addWidget(kit::label(
            theme, tr("This session was recorded before the program stored how delays are distributed."),
            TextStyle::small, "muted"));
    }
    column.addWidget(kit::notice(theme, loop.priorityGranted ? "good" : "warning",
                                 StationWords::priority(loop.priorityGranted)));
    if (!loop.priorityGranted) {
        column.addWidget(kit::label(theme, StationWords::howToGetPriority(), TextStyle::small));
        if (!loop.priorityDetail.empty())
            column.addWidget(
                kit::label(theme, tr("The system said: %1").arg(QString::fromStdString(loop.priorityDetail)),
                           TextStyle::small, "muted"));
    }
}

QWidget* StationScreen::devicesCard() const {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Devices"), TextStyle::title));
    for (const devices::Driver* driver : devices::driverCatalogue()) {
        auto* row = new QHBoxLayout;
        row->setSpacing(theme.px(12));
        auto* sign = new QLabel;
        const bool present = !driver->discover().empty();
        sign->setPixmap((present ? theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good)
                                 : theme.icon(QStringLiteral("dialog-warning"), Colour::warning))
                            .pixmap(theme.px(20), theme.px(20)));
        row->addWidget(sign, 0, Qt::AlignTop);
        auto* words = new QVBoxLayout;
        words->setSpacing(theme.px(2));
        words->addWidget(kit::label(theme, StationWords::driver(*driver), TextStyle::strong));
        words->addWidget(kit::label(theme, StationWords::needs(*driver), TextStyle::body, "muted"));
        row->addLayout(words, 3);
        row->addWidget(kit::label(theme, StationWords::forceClass(driver->deviceClass)), 1);
        box.layout->addLayout(row);
    }
    box.layout->addWidget(
        kit::label(theme,
                   tr("No maker's haptic device was connected to this version yet: the "
                      "driver for devices connected by USB, network or serial line was tested against "
                      "an emulation."),
                   TextStyle::small, "muted"));
    return box.frame;
}

QWidget* StationScreen::roomCard(const StationFacts& facts) const {
    const Theme& theme = context().theme();
    const QLocale locale = context().locale();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Free space"), TextStyle::title));
    const StorageNotice room = StorageWords::room(facts.room, locale);
    auto* notice = kit::notice(theme, room.kind, room.text);
    notice->setObjectName(QStringLiteral("station.room"));
    box.layout->addWidget(notice);
    box.layout->addWidget(
        kit::label(theme,
                   tr("A running session keeps its last seconds in memory, so that a crash loses nothing. It "
                      "needs %1 of the %2 that are free there.")
                       .arg(SessionWords::bytes(facts.room.ringNeeded_bytes, locale),
                            SessionWords::bytes(facts.room.ringFree_bytes, locale)),
                   TextStyle::body, "muted"));
    return box.frame;
}

void StationScreen::showButton() {
    if (m_test)
        m_test->setEnabled(!context().trialRuns() && !m_strip->isRunning());
    if (m_platform)
        m_platform->setReady(!context().trialRuns() && !m_strip->isRunning());
}

void StationScreen::startSelfTest() {
    if (!m_test || !m_test->isEnabled() || context().trialRuns())
        return; // a session's loop must not share the computer with a test of it
    const int ticks =
        std::max(1, place().parameters.value(QStringLiteral("self_test_ms"), kSelfTest_ms).toInt());
    m_task = std::make_shared<session::SelfTestTask>(static_cast<std::uint64_t>(ticks));
    m_token = context().background().run(
        this,
        [task = m_task](WorkToken& working) { return session::selfTestOnOwnThread(*task, working.flag()); },
        [this](const session::SelfTestResult& result) { showSelfTest(result); });
    m_token->setProgress(0, ticks);
    m_timer->start();
    m_strip->start(tr("Testing the loop. Do not use the computer meanwhile."), m_token);
    showButton();
}

void StationScreen::showSelfTest(const session::SelfTestResult& result) {
    const Theme& theme = context().theme();
    m_timer->stop();
    m_strip->stop();
    m_token.reset();
    clearColumn(*m_testBox);
    if (result.cancelled) {
        m_testBox->addWidget(
            kit::label(theme, tr("The self-test was stopped before it finished."), TextStyle::body, "muted"));
    } else {
        m_tested = result;
        note({"loop", {}, core::buildId(), loopHolds(result)}, &m_loopChecked);
        m_testRecord->setEnabled(true);
        addLoop(*m_testBox, result.loop);
        m_testBox->addWidget(kit::notice(theme, result.granted.memoryLocked ? "good" : "warning",
                                         StationWords::memory(result.granted.memoryLocked)));
    }
    showButton();
    emit selfTestEnded();
}

} // namespace chiron::desktop
