// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/check_list.h"

#include "desktop/frame/app_context.h"
#include "desktop/sound/sound_loader.h"
#include "desktop/studies/study_device.h"
#include "desktop/widgets/kit.h"
#include "session/study/presentation_order.h"

#include <algorithm>

namespace chiron::desktop {

using State = FreezeCheck::State;

namespace {

constexpr int kRuns = 40; // so that 1 in 20 can be told from none

struct Sign {
    const char* icon;
    Colour ink;
    QString words; ///< for screen readers
};

Sign signOf(State state) {
    switch (state) {
    case State::good:
        return {"dialog-ok-apply", Colour::good, CheckList::tr("good")};
    case State::advice:
        return {"dialog-warning", Colour::warning, CheckList::tr("worth a look")};
    case State::bad:
        return {"dialog-error", Colour::bad, CheckList::tr("must be corrected")};
    case State::waiting:
        return {"view-refresh", Colour::muted, CheckList::tr("being calculated")};
    }
    return {};
}

} // namespace

CheckList::CheckList(AppContext& app, const psychophysics::StudyDesign& design, FreezeFacts facts,
                     QWidget* parent)
    : QWidget(parent), m_app(app), m_design(design), m_facts(std::move(facts)),
      m_rows(new QVBoxLayout(this)) {
    m_rows->setContentsMargins(0, 0, 0, 0);
    setObjectName(QStringLiteral("check.list"));
    setAccessibleName(tr("What is checked before freezing"));
    if (m_design.trial.maskingSound && !m_facts.hasSound)
        m_facts.hasSound = loadSound().output != nullptr;
    if (!m_facts.rendersForce)
        m_facts.rendersForce = studyDeviceRendersForce();
    showChecks();
    if (m_facts.faults.empty())
        simulate();
}

CheckList::~CheckList() {
    if (m_work)
        m_work->cancel();
}

bool CheckList::has(State state) const {
    return std::any_of(m_checks.begin(), m_checks.end(),
                       [state](const FreezeCheck& check) { return check.state == state; });
}

void CheckList::simulate() {
    m_work = m_app.background().run(
        this,
        [design = m_design](WorkToken& token) -> core::Result<std::vector<psychophysics::ConditionPlan>> {
            const psychophysics::ObserverSpec observer{.weber = 0.1, .lapse = 0.02};
            std::vector<psychophysics::ConditionPlan> plans;
            for (const psychophysics::Condition& condition : design.conditions) {
                if (token.cancelled())
                    return core::fail(core::ErrorCode::cancelled, "check");
                if (condition.stimulus.attribute == psychophysics::Attribute::apex) {
                    plans.emplace_back(); // nothing is compared, so only the duration is known
                    plans.back().minutes =
                        psychophysics::minutesOf(condition, design.trial, session::trialsAtMost(condition));
                    continue;
                }
                plans.push_back(
                    psychophysics::planCondition(condition, design.trial, observer, kRuns, design.seed));
                psychophysics::examineLength(plans.back(), condition, observer, design.seed);
            }
            return plans;
        },
        [this](core::Result<std::vector<psychophysics::ConditionPlan>> plans) {
            if (!plans)
                return;
            m_facts.plans = std::move(*plans);
            showChecks();
            emit changed();
        });
}

void CheckList::showChecks() {
    m_checks = freezeChecks(m_design, m_facts, m_app.locale());
    const QString focused =
        m_shown && m_shown->isAncestorOf(focusWidget()) ? focusWidget()->objectName() : QString();
    if (m_shown) {
        m_shown->hide();
        m_shown->deleteLater();
    }
    m_shown = new QWidget;
    auto* column = new QVBoxLayout(m_shown);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(m_app.theme().px(8));
    for (const FreezeCheck& check : m_checks)
        column->addWidget(row(check));
    m_rows->addWidget(m_shown);
    if (!focused.isEmpty())
        if (auto* again = m_shown->findChild<QWidget*>(focused))
            again->setFocus();
}

QWidget* CheckList::row(const FreezeCheck& check) {
    const Theme& theme = m_app.theme();
    auto* line = new QWidget;
    line->setObjectName(QStringLiteral("check.") + check.name);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(10));
    const Sign sign = signOf(check.state);
    auto* picture = new QLabel;
    const int size = theme.px(20);
    picture->setPixmap(theme.icon(QLatin1String(sign.icon), sign.ink).pixmap(size, size));
    picture->setAccessibleName(sign.words);
    row->addWidget(picture, 0, Qt::AlignTop);
    auto* said = new QVBoxLayout;
    said->setSpacing(0);
    said->addWidget(kit::label(theme, check.title, TextStyle::strong));
    auto* words =
        kit::label(theme, check.words, TextStyle::body, check.state == State::bad ? "bad" : "muted");
    words->setObjectName(QStringLiteral("check.%1.words").arg(check.name));
    words->setAccessibleName(tr("%1, %2: %3").arg(check.title, sign.words, check.words));
    said->addWidget(words);
    row->addLayout(said, 1);
    if (check.state == State::good || check.state == State::waiting || check.tab < 0)
        return line;
    auto* go = kit::button(theme, tr("Show"), "quiet", QStringLiteral("go-next"));
    go->setObjectName(QStringLiteral("check.%1.go").arg(check.name));
    go->setAccessibleName(tr("Show %1").arg(check.title));
    connect(go, &QPushButton::clicked, this, [this, check] { emit goAsked(check); });
    row->addWidget(go, 0, Qt::AlignTop);
    return line;
}

} // namespace chiron::desktop
