// SPDX-License-Identifier: GPL-3.0-or-later
// Construction and destruction use the heap, so they are kept apart from the code that the tick calls.
#include "devices/drivers/simulated/simulated_mechanism.h"

#include <utility>

namespace chiron::devices {

SimulatedMechanism::SimulatedMechanism(const SimulatedHandSettings& settings, DeviceDescriptor descriptor,
                                       std::unique_ptr<mechanisms::HandStrategy> strategy)
    : m_descriptor(std::move(descriptor)), m_map(settings.mapping),
      m_hand(settings.hand, settings.seed, settings.toolMass_kg),
      m_wrist(settings.hand, settings.seed, settings.toolInertia_kgm2), m_strategy(std::move(strategy)) {
    if (settings.jaw)
        m_jaw.emplace(*settings.jaw, settings.jawDelay_ticks);
}

SimulatedMechanism::~SimulatedMechanism() = default;

} // namespace chiron::devices
