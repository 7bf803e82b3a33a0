// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the training screen and its texts.
#include "desktop/training/training_screen.h"

#include "desktop/exercise_face.h"
#include "desktop/frame/app_context.h"
#include "desktop/training/force_notice.h"
#include "desktop/training/header_bar.h"
#include "desktop/training/info_panel.h"
#include "desktop/training/key_filter.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/side_panel.h"
#include "desktop/training/sound_sign.h"
#include "desktop/training/training_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QResizeEvent>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kMargin_px = 12;
constexpr double kGap_px = 10;                  // between the parts
constexpr char kDetails[] = "all_measurements"; // key of a person's setting
constexpr double kCompactBelow_px = 420;        // height below which the header is compact
// The least that the scene has of the screen, at 1280×720 and 200 %, too: half of the width and two fifths of
// the height, so that it stays the largest part. Whoever cannot see where the tool is cannot work.
constexpr double kSceneWidthShare = 0.5;
constexpr double kSceneHeightShare = 0.4;
} // namespace

TrainingScreen::TrainingScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_plan(TrainingPlan::fromMap(place.parameters)),
      m_level(context.site().catalogue().find(m_plan.exercise.toStdString(), m_plan.level)), m_sound(4.0) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(title());
    m_clock.start();
    if (m_level && m_plan.trials > 0)
        if (auto tried = catalogue::withTrials(*m_level, m_plan.trials)) {
            m_tried = std::move(*tried);
            m_level = &*m_tried;
        }
    if (m_level) {
        m_cues = session::cuesOf(*m_level, m_plan.feltByPerson());
        if (const auto kind = session::exerciseKind(m_level->exercise)) {
            m_limits = session::levelLimits(*m_level);
            m_tool = (*kind)->pointerTool();
            m_tools = (*kind)->toolCount(*m_level);
        }
    }
    if (m_level)
        if (const auto face = exerciseFace(m_level->exercise)) {
            m_face = *face;
            m_live = m_face->livePart(*m_level, surroundings());
        }
    m_sound = SoundCuePlayer(m_limits.force_N);
    m_sound.setMuted(!context.settings().sound());
    const auto on = [&](const char* cue) { return context.settings().soundCue(QLatin1String(cue)); };
    m_sound.setSwitches({on("contact"), on("force"), on("lean"), on("warning")});
    m_practised = place.parameters.value(QString::fromLatin1(kPractised)).toBool();
    build();
    buildKeys();
    m_wentAhead = !m_level || !hasCard() || place.parameters.value(QString::fromLatin1(kAtOnce)).toBool();
    if (!m_wentAhead)
        showCard(context.settings().ofPerson(context.actor().personId(), readyKey(m_plan), false).toBool()
                     ? ReadyCard::Kind::brief
                     : ReadyCard::Kind::first);
}

void TrainingScreen::makeHeader() {
    const std::string language = context().language().toStdString();
    HeaderBar::Titles titles;
    titles.exercise = title();
    titles.level = m_level ? QString::fromStdString(catalogue::textIn(m_level->title, language)) : QString();
    titles.device = deviceTitle(m_plan);
    titles.sound = m_cues.sound;
    titles.familiarisation = (m_plan.familiarisation && m_plan.ownHand()) || m_plan.practises();
    if (m_level)
        if (const auto kind = session::exerciseKind(m_level->exercise))
            titles.trials = (*kind)->trialCount(*m_level);
    m_header = new HeaderBar(context().theme(), context().locale(), titles);
    m_header->setMuted(m_sound.muted());
    connect(m_header, &HeaderBar::muteAsked, this, &TrainingScreen::toggleMute);
}

void TrainingScreen::build() {
    const Theme& theme = context().theme();
    auto* column = new QVBoxLayout(this);
    const int margin = theme.px(kMargin_px);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(theme.px(kGap_px));
    makeHeader();
    column->addWidget(m_header);

    auto* middle = new QHBoxLayout;
    middle->setSpacing(theme.px(kGap_px));
    m_stage = new StatePanel(theme);
    m_pages = new QStackedWidget;
    m_stage->setContent(m_pages);
    m_stage->showLoading(tr("Preparing the scene …"));
    middle->addWidget(m_stage, 1);
    buildSide();
    middle->addWidget(m_side);
    column->addLayout(middle, 1);

    m_foot = buildFoot();
    column->addWidget(m_foot);
    m_controls = new ControlBar(theme);
    if (m_plan.practises())
        m_controls->setPractice();
    column->addWidget(m_controls);
    connect(m_controls, &ControlBar::stopAsked, this, &TrainingScreen::stopForce);
    connect(m_controls, &ControlBar::endAsked, this, &TrainingScreen::end);
    connect(m_controls, &ControlBar::startAgainAsked, this, &TrainingScreen::askToStartAgain);
    connect(m_controls, &ControlBar::resumeHereAsked, this, [this] {
        if (m_control)
            m_control->resumeHere();
    });
    connect(m_controls, &ControlBar::mainAsked, this,
            [this](ControlBar::Main main) { main == ControlBar::Main::rearm ? rearm() : pauseOrResume(); });
}

QWidget* TrainingScreen::buildFoot() {
    const Theme& theme = context().theme();
    auto* foot = new QWidget;
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(16));
    m_keysText = kit::label(theme, keysText(), TextStyle::small, "muted");
    m_keysText->setObjectName(QStringLiteral("training.keys"));
    row->addWidget(m_keysText, 1);
    // At a larger scale the keys' text needs the whole row, and it contains this as well.
    constexpr double kRoomUpTo = 1.5;
    if (m_plan.byPointer() && theme.scale() <= kRoomUpTo) {
        m_pointerText = kit::label(theme, {}, TextStyle::strong);
        m_pointerText->setObjectName(QStringLiteral("training.pointer"));
        row->addWidget(m_pointerText, 0, Qt::AlignTop);
    }
    if (const QString active = m_live && m_plan.ownHand() ? m_live->activeText(0) : QString();
        !active.isEmpty()) {
        m_activeText = kit::label(theme, active, TextStyle::strong);
        m_activeText->setObjectName(QStringLiteral("training.active_tool"));
        row->addWidget(m_activeText, 0, Qt::AlignTop);
    }
    const auto optics = m_face ? m_face->depthOfField(*m_level) : std::nullopt;
    if (!optics)
        return foot;
    const QString text = !optics->fixed ? tr("Depth of field (F)")
                         : optics->on   ? tr("Depth of field: this level keeps it on")
                                        : tr("Depth of field: this level keeps it off");
    m_depthOfField = new QCheckBox(text);
    m_depthOfField->setObjectName(QStringLiteral("training.depth_of_field"));
    m_depthOfField->setToolTip(tr("The picture is sharp at one distance only, as through a real endoscope"));
    m_depthOfField->setEnabled(!optics->fixed);
    m_depthOfField->setChecked(optics->shown(m_plan.depthOfField));
    connect(m_depthOfField, &QCheckBox::toggled, this, &TrainingScreen::setDepthOfField);
    row->addWidget(m_depthOfField, 0, Qt::AlignTop);
    return foot;
}

LiveSurroundings TrainingScreen::surroundings() {
    return {.theme = context().theme(),
            .locale = context().locale(),
            .cues = m_cues,
            .ownHand = m_plan.ownHand(),
            .hand = m_plan.driver->hand,
            .leftHanded = m_plan.workspace.leftHanded,
            .practises = m_plan.practises(),
            .report =
                [this](std::uint16_t word) {
                    if (running() && !m_storing)
                        m_control->report(word);
                },
            .freePointer = [this] { hold(); }};
}

InfoView* TrainingScreen::makeInfo() {
    return m_live
               ? m_live->makePanel()
               : new InfoPanel(context().theme(), context().locale(), m_cues, {.force_N = m_limits.force_N});
}

QString TrainingScreen::keysText() const {
    const QString own = m_live ? m_live->guide().keys : QString();
    return own.isEmpty() ? keysInWords(m_plan.ownHand(), m_tool, m_tools, m_plan.driver->hand) : own;
}

void TrainingScreen::addPartCommands(std::vector<ScreenCommand>& list) {
    for (const LiveCommand& each : m_live->commands())
        if (!each.text.isEmpty())
            list.push_back({each.text, QKeySequence(each.key), each.run, false});
}

/// Returns false if the key is none of the part's own.
bool TrainingScreen::runPartKey(int key) {
    const std::vector<LiveCommand> commands = m_live ? m_live->commands() : std::vector<LiveCommand>();
    const auto command = std::find_if(commands.begin(), commands.end(),
                                      [key](const LiveCommand& each) { return each.key == key; });
    if (command == commands.end())
        return false;
    command->run();
    return true;
}

void TrainingScreen::buildSide() {
    const Theme& theme = context().theme();
    m_side = new SidePanel(theme);
    QVBoxLayout& column = m_side->column();
    m_notice = new ForceNotice(theme);
    column.addWidget(m_notice);
    if (m_cues.sound && !m_cues.bars) { // sound cues that no bar shows
        m_soundSign = new SoundSign(theme);
        column.addWidget(m_soundSign);
    }
    if (m_level && m_level->needsForce && m_level->shownForce && !m_plan.feltByPerson()) {
        auto* note = kit::label(theme,
                                QString::fromStdString(catalogue::textIn(m_level->shownForce->note,
                                                                         context().language().toStdString())),
                                TextStyle::small, "muted");
        note->setObjectName(QStringLiteral("training.shown_force"));
        column.addWidget(note);
    }
    m_info = makeInfo();
    m_side->addInfo(m_info);
    column.addWidget(buildDetailsSwitch());
    m_notice->show(forceWords({},
                              {.felt = m_plan.feltByPerson(),
                               .ownHand = m_plan.ownHand(),
                               .endoscope = isEndoscope(),
                               .grasper = isGrasper()},
                              context().locale()));
}

QWidget* TrainingScreen::buildDetailsSwitch() {
    const database::RoleSet& roles = context().roles();
    const bool learns = roles.contains(database::Role::trainee) || roles.empty();
    m_details = new QCheckBox(tr("All measurements (F4)"));
    m_details->setObjectName(QStringLiteral("training.details"));
    m_details->setToolTip(tr(
        "Also shows single components, coordinates and further plots. Everything is recorded either way."));
    m_details->setChecked(context()
                              .settings()
                              .ofPerson(context().actor().personId(), QString::fromLatin1(kDetails), !learns)
                              .toBool());
    m_info->setDetailed(m_details->isChecked());
    connect(m_details, &QCheckBox::toggled, this, [this](bool on) {
        context().settings().setOfPerson(context().actor().personId(), QString::fromLatin1(kDetails), on);
        m_info->setDetailed(on);
        m_side->fit();
    });
    return m_details;
}

void TrainingScreen::buildKeys() {
    m_keys = new KeyFilter(*this);
    connect(m_keys, &KeyFilter::stopAsked, this, &TrainingScreen::stopForce);
    connect(m_keys, &KeyFilter::pauseAsked, this, [this] {
        if (m_pointer)
            context().settings().setOfPerson(context().actor().personId(), QString::fromLatin1(kPointerKnown),
                                             true);
        pauseOrResume();
    });
    connect(m_keys, &KeyFilter::rearmAsked, this, &TrainingScreen::rearm);
    connect(m_keys, &KeyFilter::markAsked, this, &TrainingScreen::mark);
    connect(m_keys, &KeyFilter::startAgainAsked, this, &TrainingScreen::askToStartAgain);
    connect(m_keys, &KeyFilter::detailsAsked, m_details, &QCheckBox::toggle);
    m_keys->setPanelKeys(true);
    connect(m_keys, &KeyFilter::panelAsked, m_side, &SidePanel::readOn);
    m_keys->setDepthOfFieldKey(m_depthOfField != nullptr);
    connect(m_keys, &KeyFilter::depthOfFieldAsked, this, [this] {
        if (m_depthOfField->isEnabled())
            m_depthOfField->toggle();
    });
    connect(m_keys, &KeyFilter::leaveSceneAsked, this, [this](bool) {
        window()->activateWindow();
        m_controls->mainButton()->setFocus(Qt::TabFocusReason);
    });
    connect(m_keys, &KeyFilter::toolKey, this, [this](int key, bool down) {
        if (down && m_card) {
            (void)m_card->scroll(key); // only scrolls, because nothing moves while the card is read
            return;
        }
        if ((down && runPartKey(key)) || !m_hand || (down && m_control->held()))
            return;
        down ? m_hand->keyDown(key) : m_hand->keyUp(key);
    });
}

void TrainingScreen::resizeEvent(QResizeEvent* event) {
    Screen::resizeEvent(event);
    giveSceneRoom();
}

// A part that needs more room than before must not take it from the scene.
bool TrainingScreen::event(QEvent* event) {
    const bool handled = Screen::event(event);
    if (event->type() == QEvent::LayoutRequest && m_controls)
        giveMoreRoom();
    return handled;
}

/// In this order: the panel becomes narrower, the text of the keys goes (the ready card and Help list them,
/// too), the header becomes compact, and the panel gives up the plots that bars show as well, before it has
/// to scroll (SidePanel). The buttons always stay.
void TrainingScreen::giveSceneRoom() {
    const Theme& theme = context().theme();
    const double wanted_px = m_live ? m_live->panelWidth_px() : kPanelWidth_px;
    const int beside_px = 2 * theme.px(kMargin_px) + theme.px(kGap_px);
    const int left_px = width() - beside_px - static_cast<int>(std::ceil(kSceneWidthShare * width()));
    m_side->setFixedWidth(std::clamp(left_px, 0, theme.px(wanted_px)));
    constexpr double kLargestKeysShare = 0.13;
    m_keysText->setVisible(m_keysText->heightForWidth(static_cast<int>(0.7 * width())) <=
                           kLargestKeysShare * height());
    m_header->setCompact(height() < theme.px(kCompactBelow_px));
    giveMoreRoom();
}

/// Only ever takes room from the other parts, so that the layout settles.
void TrainingScreen::giveMoreRoom() {
    const int least_px = static_cast<int>(std::ceil(kSceneHeightShare * height()));
    if (sceneHeight_px() < least_px)
        m_keysText->hide();
    if (sceneHeight_px() < least_px)
        m_header->setCompact(true);
}

/// What header, foot and controls leave.
int TrainingScreen::sceneHeight_px() const {
    const QMargins margins = layout()->contentsMargins();
    const int width_px = width() - margins.left() - margins.right();
    int left_px = height() - margins.top() - margins.bottom();
    for (const QWidget* part : {static_cast<const QWidget*>(m_header), static_cast<const QWidget*>(m_foot),
                                static_cast<const QWidget*>(m_controls)}) {
        const int wants_px =
            part->hasHeightForWidth() ? part->heightForWidth(width_px) : part->sizeHint().height();
        left_px -= std::clamp(wants_px, part->minimumHeight(), part->maximumHeight()) + layout()->spacing();
    }
    return left_px;
}

QString TrainingScreen::keptText() {
    return tr("What is recorded is kept. The session counts as stopped, not as completed.");
}

void TrainingScreen::askToEnd(const Ask& ask, const std::function<void()>& end) {
    if (m_asking)
        return;
    m_asking = true;
    QMessageBox box(QMessageBox::Question, title(), ask.question, QMessageBox::NoButton, window());
    box.setObjectName(QStringLiteral("training.ask"));
    box.setInformativeText(ask.then);
    QPushButton* keep = box.addButton(tr("Keep training"), QMessageBox::RejectRole);
    keep->setObjectName(QStringLiteral("training.ask.keep"));
    QPushButton* leave = box.addButton(ask.endText, QMessageBox::DestructiveRole);
    leave->setObjectName(QStringLiteral("training.ask.end"));
    box.setDefaultButton(keep);
    box.setEscapeButton(keep);
    box.exec();
    m_asking = false;
    if (box.clickedButton() == leave)
        end();
}

QString TrainingScreen::title() const {
    const catalogue::Exercise* exercise = context().site().catalogue().find(m_plan.exercise.toStdString());
    return exercise ? QString::fromStdString(
                          catalogue::textIn(exercise->title, context().language().toStdString()))
                    : tr("Training");
}

QString TrainingScreen::help() const {
    const QString end = isEndoscope() ? tr("When the procedure is done the debrief opens by itself.")
                                      : tr("After the last trial the debrief opens by itself.");
    return tr("This is where you train. The scene is on the left, the measurements are on the right and the "
              "controls are below. Each level "
              "shows only what belongs to it; what is hidden is still recorded.\n\n%1\n\n\"Stop force\" "
              "switches the force off at once and "
              "stops the clock. \"Re-arm\" brings the force back slowly. \"Pause\" keeps everything as it "
              "is. \"Start again\" keeps the attempt so far "
              "as stopped and begins a new one from the start.\n\n%2")
        .arg(keysText(), end);
}

std::vector<ScreenCommand> TrainingScreen::commands() {
    if (!running())
        return {};
    std::vector<ScreenCommand> list{
        {tr("Stop force"), QKeySequence(Qt::Key_Escape), [this] { stopForce(); }, false},
        {tr("Pause or go on"), QKeySequence(Qt::Key_Space), [this] { pauseOrResume(); }, false},
        {tr("Re-arm force"), QKeySequence(Qt::Key_R), [this] { rearm(); }, false},
        {tr("All measurements, or those a trainee needs"), QKeySequence(Qt::Key_F4),
         [this] { m_details->toggle(); }, false},
        {tr("Scroll down in the panel"), QKeySequence(Qt::CTRL | Qt::Key_PageDown),
         [this] { m_side->readOn(true); }, false},
        {tr("Scroll up in the panel"), QKeySequence(Qt::CTRL | Qt::Key_PageUp),
         [this] { m_side->readOn(false); }, false},
        {tr("Start again from the beginning"), QKeySequence(Qt::Key_F5), [this] { askToStartAgain(); },
         false},
        {tr("End the session"), {}, [this] { end(); }, true},
    };
    if (m_depthOfField && m_depthOfField->isEnabled())
        list.push_back({tr("Depth of field on or off"), QKeySequence(Qt::Key_F),
                        [this] { m_depthOfField->toggle(); }, false});
    if (m_plan.ownHand() && m_tool == session::PointerTool::point)
        list.push_back({tr("Mark this place"), QKeySequence(Qt::Key_Return), [this] { mark(); }, false});
    if (m_live && m_plan.ownHand())
        addPartCommands(list);
    if (m_cues.sound)
        list.push_back({tr("Sound on or off"), {}, [this] { toggleMute(); }, true});
    return list;
}

} // namespace chiron::desktop
