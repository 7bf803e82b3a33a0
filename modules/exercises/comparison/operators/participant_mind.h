// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::operators {

/// What a study's runner asks a simulated participant, after each tick and on the same thread.
class IParticipantMind {
public:
    IParticipantMind() = default;
    IParticipantMind(const IParticipantMind&) = delete;
    IParticipantMind& operator=(const IParticipantMind&) = delete;
    virtual ~IParticipantMind() = default;

    /// Every place of the trial at hand was explored: an answer can be given.
    virtual bool explored() const noexcept = 0;
    /// What it felt at a place, in the attribute's own SI unit, by its own fit; not a number where nothing usable was felt.
    virtual double estimate(int place) const noexcept = 0;
    /// Explores once more (an adjustment changed the level).
    virtual void again() noexcept = 0;
};

} // namespace chiron::operators
