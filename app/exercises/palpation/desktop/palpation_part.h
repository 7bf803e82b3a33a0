// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/desktop/palpation_map.h"
#include "desktop/training/live_part.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <optional>

namespace chiron::desktop {

class PalpationPanel;

/// The part of the training screen for palpation levels: findings with their ratings, the fingers, the live
/// map.
class PalpationPart final : public LivePart {
public:
    /// `level` must outlive this object and its panel.
    PalpationPart(const simulation::PalpationParameters& level, LiveSurroundings around);

    InfoView* makePanel() override;
    double panelWidth_px() const override { return kWidePanel_px; }
    std::unique_ptr<HandControl> takeHand(session::LiveTraining& training,
                                          std::function<void(int)> chosen) const override;
    QString activeText(int tool) const override;
    LiveGuide guide() const override;
    std::vector<LiveCommand> commands() const override;
    void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples,
              scene3d::SceneState& drawn) override;
    double lean_rad(const haptics::DisplayState& state, std::size_t tool) const override;

private:
    std::vector<ControlHint> controls() const;
    QString keysText() const;

    const simulation::PalpationParameters& m_level;
    PalpationPanel* m_panel = nullptr;
    std::optional<PalpationMap> m_map; ///< of the current trial, if the level shows it
};

} // namespace chiron::desktop
