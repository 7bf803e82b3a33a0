// SPDX-License-Identifier: GPL-3.0-or-later
// Lists interrupted runs, each with a button to resume it.
#include "desktop/study_run/run_screen.h"

#include "desktop/studies/participant_progress.h"
#include "desktop/widgets/kit.h"
#include "session/study/study_store.h"

#include <QPushButton>
#include <algorithm>

namespace chiron::desktop {

QVBoxLayout* RunScreen::buttonCell(QHBoxLayout& line) {
    auto* cell = new QWidget;
    cell->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    auto* column = new QVBoxLayout(cell);
    column->setContentsMargins(0, 0, 0, 0);
    line.addWidget(cell);
    return column;
}

QString RunScreen::nextWaiting(const QString& except) const {
    const ParticipantRow* first = nullptr;
    const ParticipantRow* asked = nullptr;
    const ParticipantRow* last = nullptr;
    std::string when;
    for (const ParticipantRow& row : study()->participants) {
        if (!isWaiting(*study(), row) || QString::fromStdString(row.participant.code) == except)
            continue;
        const bool done = row.participant.state == database::ParticipantState::completed;
        if (const ParticipantRow*& found = done ? asked : first; !found)
            found = &row;
        for (const LeftRun& left : row.left)
            if (left.lastUtc > when) {
                last = &row;
                when = left.lastUtc;
            }
    }
    const ParticipantRow* chosen = last ? last : first ? first : asked;
    return chosen ? QString::fromStdString(chosen->participant.code) : QString();
}

QPushButton* RunScreen::resumeButton(const QString& participant, const database::StudyRun& run) {
    auto* go =
        kit::button(context().theme(), tr("Resume here"), "primary", QStringLiteral("media-playback-start"));
    go->setAccessibleName(tr("Resume %1 where it was interrupted").arg(participant));
    connect(go, &QPushButton::clicked, this, [this, participant, label = session::labelOf(run)] {
        m_participant = participant;
        this->run(label);
    });
    return go;
}

QWidget* RunScreen::leftBox() {
    const Theme& theme = context().theme();
    kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("run.left"));
    box.layout->addWidget(kit::label(theme, tr("Other interrupted runs"), TextStyle::title));
    int rows = 0;
    for (const ParticipantRow& row : study()->participants)
        for (const LeftRun& left : row.left) {
            const auto run =
                std::find_if(row.runs.begin(), row.runs.end(),
                             [&](const database::StudyRun& each) { return each.id == left.run; });
            const QString code = QString::fromStdString(row.participant.code);
            if (row.participant.simulated || row.participant.state != database::ParticipantState::consented ||
                code == m_participant)
                continue;
            const kit::Box inner = kit::box(theme, "raised");
            auto* line = new QHBoxLayout;
            auto* said = new QVBoxLayout;
            said->setSpacing(theme.px(2));
            line->addLayout(said, 1);
            said->addWidget(kit::label(theme,
                                       tr("%1 · %2").arg(code, conditionName(*study(), session::labelOf(*run),
                                                                             context().language())),
                                       TextStyle::strong));
            said->addWidget(kit::label(theme, interruptedWords(*study(), left, context().locale()),
                                       TextStyle::body, "muted"));
            QPushButton* go = resumeButton(code, *run);
            go->setObjectName(QStringLiteral("run.resume.%1").arg(code));
            buttonCell(*line)->addWidget(go, 0, Qt::AlignRight);
            inner.layout->addLayout(line);
            box.layout->addWidget(inner.frame);
            ++rows;
        }
    if (rows > 0)
        return box.frame;
    delete box.frame;
    return nullptr;
}

} // namespace chiron::desktop
