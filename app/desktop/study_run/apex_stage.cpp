// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/apex_stage.h"

#include "desktop/scene3d/scene_loader.h"
#include "desktop/study_run/large_texts.h"
#include "desktop/training/scene_feed.h"
#include "desktop/widgets/kit.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace chiron::desktop {

ApexStage::ApexStage(const Theme& theme, const catalogue::ExerciseLevel& level, const Look& look,
                     QWidget* parent)
    : QWidget(parent), m_cues(session::cuesOf(level, look.felt)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    scene3d::SceneSetup setup = sceneSetupOf(level, m_cues, theme, look.leftHanded);
    setup.forceLimit_N = look.forceLimit_N;
    m_scene = scene3d::makeSceneView(setup, this).view;
    m_scene->widget()->setAccessibleName(tr("Scene"));
    m_scene->widget()->setFocusPolicy(Qt::StrongFocus);
    column->addWidget(m_scene->widget(), 1);
    column->addWidget(buildFoot(theme));
}

ApexStage::~ApexStage() = default;

QWidget* ApexStage::buildFoot(const Theme& theme) {
    auto* foot = new QWidget;
    auto* column = new QVBoxLayout(foot);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    auto* question = kit::label(theme, tr("Where is the highest point?"), TextStyle::title);
    question->setObjectName(QStringLiteral("apex.question"));
    question->setAlignment(Qt::AlignCenter);
    m_mark = kit::button(theme, tr("Here it is (Enter)"), "primary");
    m_mark->setObjectName(QStringLiteral("apex.mark"));
    m_mark->setFont(theme.font(TextStyle::title));
    m_mark->setFocusPolicy(Qt::NoFocus); // Enter belongs to the screen
    m_mark->setEnabled(false);
    connect(m_mark, &QPushButton::clicked, this, &ApexStage::markAsked);
    // At a large scale the scene needs the room of a line.
    const bool beside = areTextsLarge(theme);
    auto* asked = beside ? static_cast<QBoxLayout*>(new QHBoxLayout) : new QVBoxLayout;
    asked->setSpacing(column->spacing());
    asked->addWidget(question, beside ? 1 : 0);
    asked->addWidget(m_mark, 0, Qt::AlignHCenter);
    column->addLayout(asked);
    m_words = kit::label(theme, QStringLiteral(" "), TextStyle::strong);
    m_words->setObjectName(QStringLiteral("apex.words"));
    m_words->setAlignment(Qt::AlignCenter);
    column->addWidget(m_words);
    return foot;
}

void ApexStage::show(const haptics::DisplayState& state, bool canMark, const QString& words) {
    if (state.tools > 0) {
        if (m_start_ns == 0)
            m_start_ns = state.now_ns;
        m_drawn = sceneStateOf(state, m_cues, m_start_ns);
        if (!m_cues.object)
            // A tool drawn at the surface would reveal the sphere.
            for (scene3d::ToolView& tool : m_drawn.tool) {
                tool.drawnAtSurface = false;
                tool.p_WProxy = tool.p_WT;
            }
        m_scene->show(m_drawn);
    }
    m_mark->setEnabled(canMark);
    const QString shown = words.isEmpty() ? QStringLiteral(" ") : words; // keeps its height
    if (m_words->text() != shown)
        m_words->setText(shown);
}

} // namespace chiron::desktop
